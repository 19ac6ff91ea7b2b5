import type { KnownClasses } from '../page/known_classes';
import { facetField } from './facet_field';

export interface ClassField {
    node: HTMLElement;
    select: HTMLSelectElement;
    dispose(): void;
}

/** A choice among the classes of the collection. */
export function classField(value: string, classes: KnownClasses): ClassField {
    const field = facetField('Class', 'class', 'All classes');
    field.show(classes.values, value);
    return {
        node: field.node,
        select: field.select,
        dispose: classes.subscribe(() => field.show(classes.values, field.select.value)),
    };
}
