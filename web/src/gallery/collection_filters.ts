import { type ModelFilter, type ModelOrder, kModelOrders } from '../api/client';
import type { Facets } from '../api/types';
import { element } from '../page/element';
import { facetField } from './facet_field';
import { MoreFilters } from './more_filters';
import { type Text, say } from '../words/say';

export interface Listing {
    filter: ModelFilter;
    sort: ModelOrder;
}

export function sameListing(a: Listing, b: Listing): boolean {
    return (
        a.sort === b.sort &&
        (Object.keys(a.filter) as (keyof ModelFilter)[]).every(
            (name) => a.filter[name] === b.filter[name],
        )
    );
}

const kTypingPauseMs = 120;

const kOrderNames: Record<ModelOrder, Text> = {
    name: 'Name',
    newest: 'Newest first',
    faces: 'Most faces',
    branches: 'Most branches',
};

function labelled(label: string, control: HTMLElement): HTMLElement {
    return element(
        'label',
        { class: 'field' },
        element('span', { class: 'field-label' }, label),
        control,
    );
}

/** The fields above the cards; `onEdit` is called once one pauses with typing. */
export class CollectionFilters {
    readonly node: HTMLElement;
    private readonly name_ = element('input', {
        type: 'search',
        class: 'input',
        name: 'name',
        placeholder: say('Name contains…'),
        autocomplete: 'off',
        maxlength: 256,
    });
    private readonly class_ = facetField(say('Class'), 'class', say('All classes'));
    private readonly folder_ = facetField(say('Folder'), 'folder', say('All folders'));
    private readonly kind_ = facetField(say('Kind of file'), 'kind', say('All kinds'));
    private readonly sort_ = element(
        'select',
        { class: 'input', name: 'sort' },
        kModelOrders.map((order) => element('option', { value: order }, say(kOrderNames[order]))),
    );
    private readonly more_: MoreFilters;
    private pause_: ReturnType<typeof setTimeout> | undefined;
    private facets_: Facets | null = null;

    /** @param onOpen the filters by numbers are seen */
    constructor(first: Listing, onEdit: (listing: Listing) => void, onOpen: () => void) {
        this.more_ = new MoreFilters(() => onEdit(this.listing), onOpen);
        this.listing = first;
        this.name_.addEventListener('input', () => {
            clearTimeout(this.pause_);
            this.pause_ = setTimeout(() => onEdit(this.listing), kTypingPauseMs);
        });
        for (const field of [
            this.class_.select,
            this.folder_.select,
            this.kind_.select,
            this.sort_,
        ]) {
            field.addEventListener('change', () => onEdit(this.listing));
        }
        this.node = element(
            'form',
            {
                class: 'filters',
                role: 'search',
                'aria-label': say('Filter the collection'),
                submit: (event: Event) => event.preventDefault(),
            },
            labelled(say('Name'), this.name_),
            this.class_.node,
            this.folder_.node,
            this.kind_.node,
            labelled(say('Order'), this.sort_),
            this.more_.node,
        );
    }

    /** Whether somebody looks at the filters by numbers. */
    get isOpen(): boolean {
        return this.more_.node.open;
    }

    get listing(): Listing {
        return {
            filter: {
                name: this.name_.value.trim(),
                className: this.class_.select.value,
                folder: this.folder_.select.value,
                kind: this.kind_.select.value,
                ...this.more_.values,
            },
            sort: kModelOrders.find((order) => order === this.sort_.value) ?? 'name',
        };
    }

    set listing({ filter, sort }: Listing) {
        // Not while one types: what was typed meanwhile would go.
        if (this.name_.value.trim() !== filter.name) {
            this.name_.value = filter.name;
        }
        this.class_.show(this.facets_?.classes ?? [], filter.className);
        this.folder_.show(this.facets_?.folders ?? [], filter.folder);
        this.kind_.show(this.facets_?.kinds ?? [], filter.kind);
        this.more_.show(this.facets_, filter);
        this.sort_.value = sort;
    }

    /** What there is to choose from. A choice of nothing is not offered. */
    offer(facets: Facets): void {
        this.facets_ = facets;
        const { filter } = this.listing;
        this.class_.show(facets.classes, filter.className);
        this.folder_.show(facets.folders, filter.folder);
        this.kind_.show(facets.kinds, filter.kind);
        this.more_.show(facets, filter);
        const some = (values: readonly unknown[], least: number, chosen: string): boolean =>
            values.length >= least || chosen !== '';
        this.class_.node.hidden = !some(
            facets.classes.filter(({ value }) => value !== null),
            1,
            filter.className,
        );
        this.folder_.node.hidden = !some(facets.folders, 1, filter.folder);
        this.kind_.node.hidden = !some(facets.kinds, 2, filter.kind);
    }

    dispose(): void {
        clearTimeout(this.pause_);
    }
}
