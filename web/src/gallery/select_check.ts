import { element } from '../page/element';
import type { Chosen, Selection } from '../page/selection';
import { say } from '../words/say';

/** A box in the corner of a card that chooses its model. */
export function selectCheck(model: Chosen, selection: Selection): HTMLElement {
    const box = element('input', {
        type: 'checkbox',
        'aria-label': say('Select {name}', { name: model.name }),
        'data-choose': model.id,
        checked: selection.has(model.id),
    });
    box.addEventListener('change', () => selection.set(model, box.checked));
    return element('label', { class: 'card-check' }, box);
}

/** After the choice has changed elsewhere. */
export function showChoice(selection: Selection): void {
    for (const box of document.querySelectorAll<HTMLInputElement>('input[data-choose]')) {
        box.checked = selection.has(Number(box.dataset.choose));
    }
}
