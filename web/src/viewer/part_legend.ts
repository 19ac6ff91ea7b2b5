import type { SegmentPart } from '../api/elements';
import { element } from '../page/element';

export interface PartLegendOptions {
    parts: readonly SegmentPart[];
    /** `#rrggbb` by the number of the part. */
    colors: readonly string[];
    /** A row got or lost the pointer or the focus. */
    onChoose: (part: number | null) => void;
}

export interface PartLegend {
    node: HTMLElement;
    highlight(part: number | null): void;
}

export function formatShare(share: number): string {
    return `${(100 * share).toFixed(1)} %`;
}

/** The parts, the largest first; numbers from 1, since colour alone must not tell. */
export function partLegend({ parts, colors, onChoose }: PartLegendOptions): PartLegend {
    const most = Math.max(0, ...parts.map((part) => part.area_share));
    const rows = parts.map((part, index) => {
        const choose = (): void => onChoose(index);
        const leave = (): void => onChoose(null);
        return element(
            'tr',
            { tabindex: 0, pointerenter: choose, pointerleave: leave, focus: choose, blur: leave },
            element(
                'th',
                { scope: 'row' },
                element('span', { class: 'swatch', '--color': colors[index] }),
                index + 1,
            ),
            element(
                'td',
                { class: 'share-bar' },
                element('span', {
                    '--color': colors[index],
                    '--share': (most > 0 ? part.area_share / most : 0).toFixed(4),
                }),
            ),
            element('td', { class: 'number' }, formatShare(part.area_share)),
        );
    });
    const table = element(
        'table',
        { class: 'table match-table part-legend' },
        element('caption', {}, 'Parts by their share of the surface'),
        element(
            'thead',
            {},
            element(
                'tr',
                {},
                element('th', { scope: 'col' }, 'Part'),
                element('th', { scope: 'col', colspan: 2 }, 'Area'),
            ),
        ),
        element('tbody', {}, rows),
    );
    return {
        node: element('div', { class: 'table-scroll' }, table),
        highlight(chosen) {
            for (const [index, row] of rows.entries()) {
                row.classList.toggle('chosen', index === chosen);
            }
        },
    };
}
