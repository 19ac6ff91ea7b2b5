export interface BarSeries {
    name: string;
    /** `#rrggbb`. */
    color: string;
    /** From 0 to 1, one for each class. */
    values: readonly number[];
}

const kLabelWidth = 160;
const kBarWidth = 440;
const kBarHeight = 8;
const kGap = 10;
const kHead = 28;

function markup(text: string): string {
    const kEscapes: Readonly<Record<string, string>> = {
        '&': '&amp;',
        '<': '&lt;',
        '>': '&gt;',
        '"': '&quot;',
    };
    return text.replace(/[&<>"]/g, (sign) => kEscapes[sign] ?? sign);
}

/** Bars by class as a picture that stands alone. */
export function barsSvg(names: readonly string[], series: readonly BarSeries[]): string {
    const rowHeight = series.length * kBarHeight + kGap;
    const width = kLabelWidth + kBarWidth + 56;
    const height = kHead + names.length * rowHeight + kGap;
    const legend = series.map(
        ({ name, color }, at) =>
            `<rect x="${kLabelWidth + at * 120}" y="8" width="10" height="10" fill="${color}"/>` +
            `<text x="${kLabelWidth + at * 120 + 16}" y="17">${markup(name)}</text>`,
    );
    const rows = names.flatMap((name, row) => {
        const top = kHead + row * rowHeight;
        const middle = top + (series.length * kBarHeight) / 2 + 4;
        return [
            `<text x="${kLabelWidth - 8}" y="${middle}" text-anchor="end">${markup(name)}</text>`,
            ...series.map(({ color, values }, at) => {
                const share = Math.min(1, Math.max(0, values[row] ?? 0));
                return `<rect x="${kLabelWidth}" y="${top + at * kBarHeight}" width="${(share * kBarWidth).toFixed(1)}" height="${kBarHeight - 1}" fill="${color}"/>`;
            }),
        ];
    });
    return [
        `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12">`,
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        ...legend,
        ...rows,
        '</svg>\n',
    ].join('\n');
}
