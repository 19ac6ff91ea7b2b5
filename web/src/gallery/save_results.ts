import type { Hit, SearchResult } from '../api/types';
import { type Columns, csv } from '../page/csv';
import { element } from '../page/element';
import { saveText } from '../page/save_file';
import { say } from '../words/say';

const kColumns: Columns<Hit> = [
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

/** A line for each hit below one of names. */
export function csvOf(hits: readonly Hit[]): string {
    return csv(hits, kColumns);
}

/** Buttons that save the hits as files. */
export function saveResults(result: SearchResult): HTMLElement {
    const name = `like-${result.query.name}`;
    const button = (label: string, press: () => void): HTMLElement =>
        element('button', { type: 'button', class: 'link-button', click: press }, label);
    return element(
        'p',
        { class: 'save-results' },
        button(say('Save as CSV'), () => saveText(`${name}.csv`, 'text/csv', csvOf(result.hits))),
        button(say('Save as JSON'), () =>
            saveText(`${name}.json`, 'application/json', JSON.stringify(result, null, 1)),
        ),
    );
}
