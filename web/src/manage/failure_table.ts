import type { IndexFailure } from '../api/administration';
import { adviceFor } from '../page/advice';
import { csv } from '../page/csv';
import { element } from '../page/element';
import { formatCount } from '../page/format';
import { saveText } from '../page/save_file';
import { say } from '../words/say';

const kMostRows = 500;

/** Files that are not in the collection, why, and what to do about it. */
export function failureTable(failures: readonly IndexFailure[]): HTMLElement {
    if (failures.length === 0) {
        return element('p', { class: 'fine' }, say('Every file could be indexed.'));
    }
    const save = (): void =>
        saveText(
            'failures.csv',
            'text/csv',
            csv(failures, [
                ['path', ({ path }) => path],
                ['code', ({ code }) => code],
                ['message', ({ message }) => message],
                ['failed_at', ({ failed_at }) => failed_at],
            ]),
        );
    const heads = [say('File'), say('Code'), say('What to do')];
    return element(
        'div',
        { class: 'failures' },
        element(
            'div',
            // What can be scrolled can be reached with the keyboard.
            { class: 'table-scroll', tabindex: 0 },
            element(
                'table',
                { class: 'table' },
                element(
                    'caption',
                    { class: 'visually-hidden' },
                    say('Files that could not be indexed'),
                ),
                element(
                    'thead',
                    {},
                    element(
                        'tr',
                        {},
                        heads.map((head) => element('th', { scope: 'col' }, head)),
                    ),
                ),
                element(
                    'tbody',
                    {},
                    failures
                        .slice(0, kMostRows)
                        .map(({ path, code, message }) =>
                            element(
                                'tr',
                                {},
                                element(
                                    'th',
                                    { scope: 'row' },
                                    path,
                                    element('p', { class: 'fine' }, message),
                                ),
                                element('td', {}, element('code', {}, code)),
                                element('td', {}, say(adviceFor(code))),
                            ),
                        ),
                ),
            ),
        ),
        element(
            'button',
            { type: 'button', class: 'link-button', click: save },
            say('Save all {count} as CSV', { count: formatCount(failures.length) }),
        ),
    );
}
