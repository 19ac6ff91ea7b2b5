import type { Context } from '../page/context';
import { copyText } from '../page/copy_text';
import { csv } from '../page/csv';
import { element, replace } from '../page/element';
import { formatCount } from '../page/format';
import { formatRoute, resultsOf } from '../page/routes';
import { saveText } from '../page/save_file';
import type { Chosen } from '../page/selection';
import { say } from '../words/say';
import { showChoice } from './select_check';

export interface SelectionBar {
    node: HTMLElement;
    dispose(): void;
}

/** A line for each chosen model, for whatever takes lists. */
export function listOf(chosen: readonly Chosen[]): string {
    return csv(chosen, [
        ['id', ({ id }) => id],
        ['name', ({ name }) => name],
        ['class', (each) => each.class],
        ['path', ({ path }) => path],
    ]);
}

function compareLink([first, second, ...more]: readonly Chosen[]): HTMLElement {
    const label = say('Compare');
    if (!first || !second || more.length > 0) {
        return element(
            'button',
            { type: 'button', class: 'button', disabled: true, title: say('Select two models') },
            label,
        );
    }
    const href = formatRoute(
        resultsOf({ kind: 'model', id: first.id }, undefined, { kind: 'hit', id: second.id }),
    );
    return element('a', { class: 'button', href }, label);
}

/** What can be done with the models that are chosen; not there while none are. */
export function selectionBar({ selection, announce }: Context): SelectionBar {
    const node = element('section', {
        class: 'selection-bar',
        'aria-label': say('Selected models'),
        hidden: true,
    });
    const button = (label: string, press: () => void): HTMLElement =>
        element('button', { type: 'button', class: 'button button-quiet', click: press }, label);
    const copy = async (): Promise<void> => {
        const paths = selection.list.map(({ path, name }) => path || name);
        announce(
            (await copyText(paths.join('\n')))
                ? say('Copied')
                : say('The browser does not allow it'),
        );
    };
    const show = (): void => {
        const chosen = selection.list;
        node.hidden = chosen.length === 0;
        replace(
            node,
            chosen.length > 0 && [
                element(
                    'span',
                    { class: 'selection-count', title: chosen.map(({ name }) => name).join(', ') },
                    say('{count} selected', { count: formatCount(chosen.length) }),
                ),
                compareLink(chosen),
                button(say('Copy paths'), () => void copy()),
                button(say('Save the list'), () =>
                    saveText('models.csv', 'text/csv', listOf(selection.list)),
                ),
                button(say('Clear'), () => selection.clear()),
            ],
        );
        showChoice(selection);
    };
    show();
    return { node, dispose: selection.subscribe(show) };
}
