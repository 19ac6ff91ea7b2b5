import type { ModelFilter } from '../api/client';
import { isAbort } from '../api/problem';
import type { Context } from '../page/context';
import { element, replace } from '../page/element';
import { formatCount, formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, type HomeRoute, kHome } from '../page/routes';
import { CollectionFilters, type Listing, sameListing } from './collection_filters';
import { modelCard } from './model_card';
import { kPageSize, ModelPages } from './model_pages';
import { skeletonCards } from './thumbnail';
import { VirtualGrid } from './virtual_grid';
import { say } from '../words/say';

export interface Collection {
    node: HTMLElement;
    /** Once its height is known. */
    ready: Promise<void>;
    show(route: HomeRoute): void;
    dispose(): void;
}

const kCardsWhileLoading = 12;
const kAddressPauseMs = 200;

function isAll(filter: ModelFilter): boolean {
    return Object.values(filter).every((value) => value === '');
}

function nothingThere(filter: ModelFilter): HTMLElement {
    return isAll(filter)
        ? emptyNotice(
              say('The collection is empty.'),
              say('Add models by this command, then reload this page:'),
              ' ',
              element('code', {}, 'ossuary index --index FILE FOLDER'),
          )
        : emptyNotice(
              say('No model fits these filters.'),
              element('a', { href: formatRoute(kHome) }, say('Show all models')),
          );
}

/** All models, or those that fit the filters; as many as there may be. */
class ModelCollection implements Collection {
    readonly node: HTMLElement;
    readonly ready: Promise<void>;
    private readonly context_: Context;
    private readonly fields_: CollectionFilters;
    private readonly grid_: VirtualGrid;
    private readonly count_ = element('span', { class: 'count' });
    private readonly waiting_ = element('ul', { class: 'grid', 'aria-hidden': 'true' });
    private readonly empty_ = element('div', {});
    /** Where the hand is, wherever that is in the list. */
    private readonly problem_ = element('div', { class: 'grid-problem' });
    private listing_: Listing;
    private pages_: ModelPages | null = null;
    private facets_ = new AbortController();
    private at_: number;
    private pause_: ReturnType<typeof setTimeout> | undefined;

    constructor(route: HomeRoute, context: Context) {
        this.context_ = context;
        this.listing_ = { filter: route.filter, sort: route.sort };
        this.at_ = route.at;
        this.fields_ = new CollectionFilters(
            this.listing_,
            (listing) => this.edit(listing),
            () => void this.loadFacets(this.listing_.filter),
        );
        this.grid_ = new VirtualGrid({
            label: say('Models of the collection'),
            card: (model) => modelCard(model, context.selection),
            onMove: (first) => this.move(first),
        });
        this.node = element(
            'section',
            { class: 'collection', 'aria-labelledby': 'collection-title' },
            element(
                'div',
                { class: 'section-head' },
                element('h2', { id: 'collection-title' }, say('Collection'), ' ', this.count_),
                this.fields_.node,
            ),
            this.empty_,
            this.waiting_,
            this.grid_.node,
            this.problem_,
        );
        this.ready = this.load();
    }

    show({ filter, sort }: HomeRoute): void {
        const listing = { filter, sort };
        if (!sameListing(listing, this.listing_)) {
            this.fields_.listing = listing;
            this.restart(listing);
        }
    }

    dispose(): void {
        clearTimeout(this.pause_);
        this.facets_.abort();
        this.pages_?.dispose();
        this.fields_.dispose();
        this.grid_.dispose();
    }

    private edit(listing: Listing): void {
        if (!sameListing(listing, this.listing_)) {
            this.context_.rewrite({ page: 'home', ...listing, at: 0 });
            this.restart(listing);
        }
    }

    private restart(listing: Listing): void {
        this.listing_ = listing;
        this.at_ = 0;
        void this.load();
    }

    private move(first: number): void {
        this.at_ = first;
        clearTimeout(this.pause_);
        this.pause_ = setTimeout(() => {
            this.context_.rewrite({ page: 'home', ...this.listing_, at: this.at_ });
        }, kAddressPauseMs);
    }

    private async load(): Promise<void> {
        const { client } = this.context_;
        const { filter, sort } = this.listing_;
        this.pages_?.dispose();
        const pages = new ModelPages(client, filter, sort, {
            onChange: () => pages === this.pages_ && this.refresh(),
            onProblem: (error) => pages === this.pages_ && this.complain(error),
        });
        this.pages_ = pages;
        this.problem_.replaceChildren();
        void this.loadFacets(filter);
        if (this.grid_.node.childElementCount === 0) {
            this.empty_.replaceChildren();
            replace(this.waiting_, skeletonCards(kCardsWhileLoading));
        }
        const at = this.at_;
        await pages.want(at, at + kPageSize);
        if (pages !== this.pages_ || pages.total === null) {
            return;
        }
        if (at > 0) {
            this.grid_.scrollTo(Math.min(at, pages.total));
        }
        this.context_.announce(
            say('{models} in the collection fit the filters', {
                models: formatPlural(pages.total, 'model', 'models'),
            }),
        );
    }

    /** Counts are a help, not more: without them one can still look around. */
    private async loadFacets(filter: ModelFilter): Promise<void> {
        this.facets_.abort();
        this.facets_ = new AbortController();
        const { signal } = this.facets_;
        try {
            // Loops come later, and only to who looks at them.
            for (const withLoops of this.fields_.isOpen ? [false, true] : [false]) {
                const facets = await this.context_.client.facets(filter, signal, withLoops);
                if (signal.aborted) {
                    return;
                }
                this.fields_.offer(facets);
            }
        } catch {
            // Asked again with the next filter.
        }
    }

    private refresh(): void {
        const { pages_: pages } = this;
        if (!pages || pages.total === null) {
            return;
        }
        this.waiting_.replaceChildren();
        this.problem_.replaceChildren();
        this.count_.textContent = formatCount(pages.total);
        replace(this.empty_, pages.total === 0 ? nothingThere(this.listing_.filter) : null);
        this.grid_.take(pages);
    }

    private complain(error: unknown): void {
        if (isAbort(error)) {
            return;
        }
        this.waiting_.replaceChildren();
        const retry = (): void => {
            this.problem_.replaceChildren();
            if (this.pages_?.total === null) {
                void this.load();
            } else {
                this.grid_.refresh();
            }
        };
        replace(this.problem_, problemNotice(error, { retry }));
    }
}

export function collection(route: HomeRoute, context: Context): Collection {
    return new ModelCollection(route, context);
}
