import { element, replace } from '../page/element';
import { formatCount } from '../page/format';
import type { FacetValues } from '../page/known_facets';

export interface FacetField {
    node: HTMLElement;
    select: HTMLSelectElement;
    /** The values to choose from; the chosen one stays, though no model has it any more. */
    show(values: FacetValues, chosen: string): void;
}

/** A value of many to filter by, each with how many models have it. */
export function facetField(
    label: string,
    name: string,
    all: string,
    nameOf: (value: string) => string = (value) => value,
): FacetField {
    const select = element('select', { class: 'input', name });
    const option = (value: string, text: string): HTMLElement => element('option', { value }, text);
    const show = (values: FacetValues, chosen: string): void => {
        const options = values.flatMap(({ value, models }) =>
            value === null ? [] : option(value, `${nameOf(value)} (${formatCount(models)})`),
        );
        const known = chosen === '' || values.some(({ value }) => value === chosen);
        replace(select, option('', all), known ? null : option(chosen, nameOf(chosen)), options);
        select.value = chosen;
    };
    show([], '');
    return {
        node: element(
            'label',
            { class: 'field' },
            element('span', { class: 'field-label' }, label),
            select,
        ),
        select,
        show,
    };
}
