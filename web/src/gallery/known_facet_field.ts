import type { FacetName, KnownFacets } from '../page/known_facets';
import { say, type Text } from '../words/say';
import { facetField } from './facet_field';

export interface KnownFacetField {
    node: HTMLElement;
    select: HTMLSelectElement;
    dispose(): void;
}

interface FacetWords {
    name: string;
    label: Text;
    all: Text;
    /** Fewer values are no choice. */
    least: number;
}

const kWords: Readonly<Record<FacetName, FacetWords>> = {
    classes: { name: 'class', label: 'Class', all: 'All classes', least: 1 },
    folders: { name: 'folder', label: 'Folder', all: 'All folders', least: 1 },
    kinds: { name: 'kind', label: 'Kind of file', all: 'All kinds', least: 2 },
};

/** A choice among what the models of the collection are like; hidden where there is nothing to choose. */
export function knownFacetField(
    facet: FacetName,
    value: string,
    facets: KnownFacets,
): KnownFacetField {
    const { name, label, all, least } = kWords[facet];
    const field = facetField(say(label), name, say(all));
    const show = (chosen: string): void => {
        const values = facets.values(facet);
        field.show(values, chosen);
        const some = values.filter((each) => each.value !== null).length;
        field.node.hidden = some < least && chosen === '';
    };
    show(value);
    return {
        node: field.node,
        select: field.select,
        dispose: facets.subscribe(() => show(field.select.value)),
    };
}
