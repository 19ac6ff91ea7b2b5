import type { SegmentPart } from '../api/elements';
import { element } from '../page/element';
import { say } from '../words/say';

export interface PartLegendOptions {
    parts: readonly SegmentPart[];
    /** `#rrggbb` by the number of the part. */
    colors: readonly string[];
    /** A row got or lost the pointer or the focus. */
    onChoose: (part: number | null) => void;
    /** Searches for models that have a part. */
    onFind: (part: number) => void;
}

export interface PartLegend {
    node: HTMLElement;
    highlight(part: number | null): void;
}

export function formatShare(share: number): string {
    return `${(100 * share).toFixed(1)} %`;
}

/** The parts, the largest first; numbers from 1, since colour alone must not tell. */
export function partLegend({ parts, colors, onChoose, onFind }: PartLegendOptions): PartLegend {
    const most = Math.max(0, ...parts.map((part) => part.area_share));
    const rows = parts.map((part, index) => {
        const choose = (): void => onChoose(index);
        const leave = (): void => onChoose(null);
        return element(
            'tr',
            {
                pointerenter: choose,
                pointerleave: leave,
                focusin: choose,
                focusout: leave,
            },
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
            element(
                'td',
                {},
                element(
                    'button',
                    {
                        type: 'button',
                        class: 'link-button',
                        click: () => onFind(index),
                        'aria-label': say('Find models with part {number}', { number: index + 1 }),
                    },
                    say('Find'),
                ),
            ),
        );
    });
    const table = element(
        'table',
        { class: 'table match-table part-legend' },
        element('caption', {}, say('Parts by their share of the surface')),
        element(
            'thead',
            {},
            element(
                'tr',
                {},
                element('th', { scope: 'col' }, say('Part')),
                element('th', { scope: 'col', colspan: 2 }, say('Area')),
                element(
                    'th',
                    { scope: 'col' },
                    element('span', { class: 'visually-hidden' }, say('Models with it')),
                ),
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
