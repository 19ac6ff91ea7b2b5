import { type Child, element } from '../page/element';

/** What fills a viewer's dialog: the stage and, beside or below it, a column of text and tables. */
export function dialogContent(stage: Child, ...side: Child[]): HTMLElement {
    return element(
        'div',
        { class: 'dialog-content' },
        element('div', { class: 'stage' }, stage),
        element('div', { class: 'dialog-side' }, ...side),
    );
}
