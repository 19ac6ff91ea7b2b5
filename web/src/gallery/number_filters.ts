import type { NumberFilter } from '../api/client';
import type { Facets } from '../api/types';
import { element } from '../page/element';
import { formatCount } from '../page/format';
import { say, type Text } from '../words/say';
import { facetField } from './facet_field';

const kFields: readonly {
    name: keyof NumberFilter;
    facet: 'branches' | 'loops' | 'extents' | 'units';
    label: Text;
    all: Text;
    /** Fewer values are no choice. */
    least: number;
    nameOf: (value: string) => string;
}[] = [
    {
        name: 'branches',
        facet: 'branches',
        label: 'Branches',
        all: 'Any number',
        least: 2,
        nameOf: nameOfCounts,
    },
    {
        name: 'loops',
        facet: 'loops',
        label: 'Loops',
        all: 'Any number',
        least: 2,
        nameOf: nameOfCounts,
    },
    {
        name: 'extent',
        facet: 'extents',
        label: 'Longest side',
        all: 'Any size',
        least: 2,
        nameOf: nameOfSides,
    },
    {
        name: 'unit',
        facet: 'units',
        label: 'Unit of the file',
        all: 'All units',
        least: 1,
        nameOf: (unit) => unit,
    },
];

function between(least: string, most: string): string {
    return most === '' ? say('{least} and more', { least }) : `${least}–${most}`;
}

/** `5-8` as people read it. */
export function nameOfCounts(range: string): string {
    const [least = '', most] = range.split('-');
    return most === undefined ? least : between(least, most);
}

/** `1000-10000mm`: in the unit that one would say it in. */
export function nameOfSides(range: string): string {
    const [least = 0, most = 0] = range.replace('mm', '').split('-').map(Number);
    if (!range.endsWith('mm')) {
        const name = between(formatCount(least), most === 0 ? '' : formatCount(most));
        return `${name} (${say('no unit')})`;
    }
    const [unit, size] = least >= 1e6 ? ['km', 1e6] : least >= 1e3 ? ['m', 1e3] : ['mm', 1];
    const text = (side: number): string => formatCount(side / size);
    return most === 0
        ? between(`${text(least)} ${unit}`, '')
        : `${between(text(least), text(most))} ${unit}`;
}

export interface NumberFields {
    node: HTMLElement;
    show(facets: Facets | null, chosen: NumberFilter): void;
}

/** Ranges of what models count, each with how many models are in it. */
export function numberFields(
    onChange: (name: keyof NumberFilter, value: string) => void,
): NumberFields {
    const fields = kFields.map((field) => ({
        ...field,
        field: facetField(say(field.label), field.name, say(field.all), field.nameOf),
    }));
    for (const { name, field } of fields) {
        field.select.addEventListener('change', () => onChange(name, field.select.value));
    }
    return {
        node: element(
            'div',
            { class: 'filters' },
            fields.map(({ field }) => field.node),
        ),
        show(facets, chosen) {
            for (const { name, facet, least, field } of fields) {
                const values = facets?.[facet];
                // Loops that are not counted yet: as they were.
                if (!values && field.select.value === chosen[name]) {
                    continue;
                }
                field.show(values ?? [], chosen[name]);
                field.node.hidden =
                    (values ?? []).filter(({ value }) => value !== null).length < least &&
                    chosen[name] === '';
            }
        },
    };
}
