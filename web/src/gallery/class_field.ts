import { element, replace } from '../page/element';
import type { KnownClasses } from '../page/known_classes';

export interface ClassField {
    node: HTMLElement;
    input: HTMLInputElement;
    dispose(): void;
}

let fields = 0;

/** A text field, because the classes are not known in full; those seen so far are suggested. */
export function classField(value: string, classes: KnownClasses): ClassField {
    fields += 1;
    const list = element('datalist', { id: `classes-${fields}` });
    const input = element('input', {
        type: 'text',
        class: 'input',
        name: 'class',
        value,
        list: list.id,
        placeholder: 'All classes',
        autocomplete: 'off',
        maxlength: 256,
    });
    const suggest = (): void =>
        replace(
            list,
            classes.names.map((name) => element('option', { value: name })),
        );
    suggest();
    return {
        node: element(
            'label',
            { class: 'field' },
            element('span', { class: 'field-label' }, 'Class'),
            input,
            list,
        ),
        input,
        dispose: classes.subscribe(suggest),
    };
}
