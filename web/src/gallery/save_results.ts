import type { Hit, SearchResult } from '../api/types';
import { element } from '../page/element';

type Field = string | number | null;

const kColumns: readonly (readonly [name: string, of: (hit: Hit) => Field])[] = [
    ['rank', (hit) => hit.rank],
    ['id', (hit) => hit.id],
    ['name', (hit) => hit.name],
    ['class', (hit) => hit.class],
    ['path', (hit) => hit.path],
    ['distance', (hit) => hit.distance],
    ['build_difference', (hit) => hit.build_difference],
    ['pose_difference', (hit) => hit.pose_difference],
    ['matched_nodes', (hit) => hit.matched_nodes],
    ['faces', (hit) => hit.faces],
    ['copies', (hit) => hit.copies],
];

/**
 * Quoted where it has to be (RFC 4180). A spreadsheet takes what begins like a formula for one, and
 * names come from files: such a name gets an apostrophe in front.
 */
function quoted(field: Field): string {
    const text = String(field ?? '');
    const plain = typeof field === 'string' && /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
    return /[",\r\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}

/** A line for each hit below one of names. */
export function csvOf(hits: readonly Hit[]): string {
    const lines = [
        kColumns.map(([name]) => name),
        ...hits.map((hit) => kColumns.map(([, of]) => quoted(of(hit)))),
    ];
    return lines.map((line) => `${line.join(',')}\r\n`).join('');
}

function save(name: string, type: string, text: string): void {
    const href = URL.createObjectURL(new Blob([text], { type }));
    element('a', { href, download: name }).click();
    // The browser has taken it by then.
    setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

/** Buttons that save the hits as files. */
export function saveResults(result: SearchResult): HTMLElement {
    const name = `like-${result.query.name}`;
    const button = (label: string, press: () => void): HTMLElement =>
        element('button', { type: 'button', class: 'link-button', click: press }, label);
    return element(
        'p',
        { class: 'save-results' },
        button('Save as CSV', () => save(`${name}.csv`, 'text/csv', csvOf(result.hits))),
        button('Save as JSON', () =>
            save(`${name}.json`, 'application/json', JSON.stringify(result, null, 1)),
        ),
    );
}
