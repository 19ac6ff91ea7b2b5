import { isAbort } from '../api/problem';
import type { ModelPage } from '../api/types';
import type { Context } from '../page/context';
import { element, replace } from '../page/element';
import { formatCount, formatPlural } from '../page/format';
import type { KnownClasses } from '../page/known_classes';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, kHome } from '../page/routes';
import { type ClassField, classField } from './class_field';
import { modelCard } from './model_card';
import { skeletonCards } from './thumbnail';

export interface CollectionFilter {
    name: string;
    className: string;
}

export interface Collection {
    node: HTMLElement;
    show(filter: CollectionFilter): void;
    dispose(): void;
}

const kTypingPauseMs = 220;
const kCardsWhileLoading = 12;

function sameFilter(a: CollectionFilter, b: CollectionFilter): boolean {
    return a.name === b.name && a.className === b.className;
}

function nothingThere(filter: CollectionFilter): HTMLElement {
    return filter.name !== '' || filter.className !== ''
        ? emptyNotice(
              'No model fits these filters.',
              element('a', { href: formatRoute(kHome) }, 'Show all models'),
          )
        : emptyNotice(
              'The collection is empty.',
              'Add models with ',
              element('code', {}, 'ossuary index --index FILE FOLDER'),
              ' and reload this page.',
          );
}

/** The cards of the models that fit a filter, a page at a time. */
class ModelList {
    readonly count = element('span', { class: 'count' });
    readonly message = element('div', {});
    readonly grid = element('ul', { class: 'grid', 'aria-label': 'Models of the collection' });
    readonly foot = element('div', { class: 'grid-foot', hidden: true });
    private readonly more_ = element('button', { type: 'button', class: 'button' }, 'Show more');
    private readonly context_: Context;
    private filter_: CollectionFilter;
    private cursor_: string | null = null;
    private shown_ = 0;
    private running_ = new AbortController();

    constructor(filter: CollectionFilter, context: Context) {
        this.filter_ = { ...filter };
        this.context_ = context;
        this.more_.addEventListener('click', () => void this.load());
        this.foot.append(this.more_);
        void this.load();
    }

    get filter(): CollectionFilter {
        return this.filter_;
    }

    /** From the first page on. */
    restart(filter: CollectionFilter): void {
        this.filter_ = filter;
        this.cursor_ = null;
        void this.load();
    }

    dispose(): void {
        this.running_.abort();
    }

    private async load(): Promise<void> {
        this.running_.abort();
        this.running_ = new AbortController();
        const { signal } = this.running_;
        const continued = this.cursor_ !== null;
        this.more_.disabled = true;
        this.message.replaceChildren();
        if (!continued) {
            this.foot.hidden = true;
            replace(this.grid, skeletonCards(kCardsWhileLoading));
        }
        try {
            const { client } = this.context_;
            const page = await client.models({ ...this.filter_, cursor: this.cursor_ }, signal);
            this.show(page, continued);
        } catch (error) {
            if (!isAbort(error)) {
                if (!continued) {
                    this.grid.replaceChildren();
                }
                replace(this.message, problemNotice(error, { retry: () => void this.load() }));
            }
        } finally {
            this.more_.disabled = false;
        }
    }

    private show(page: ModelPage, continued: boolean): void {
        if (!continued) {
            this.grid.replaceChildren();
            this.shown_ = 0;
        }
        this.context_.classes.add(page.models.map((model) => model.class));
        const cards = page.models.map(modelCard);
        this.grid.append(...cards);
        if (continued) {
            cards[0]?.querySelector('a')?.focus();
        }
        this.shown_ += cards.length;
        this.cursor_ = page.next_cursor;
        this.foot.hidden = this.cursor_ === null;
        const left = formatCount(Math.max(0, page.total - this.shown_));
        this.more_.textContent = `Show more (${left} left)`;
        this.count.textContent = formatCount(page.total);
        const models = formatPlural(page.total, 'model');
        this.context_.announce(`${models} in the collection fit the filters`);
        if (page.total === 0) {
            replace(this.message, nothingThere(this.filter_));
        }
    }
}

/** The fields above the cards; `onEdit` is called once one pauses with typing. */
class FilterFields {
    readonly node: HTMLElement;
    private readonly name_: HTMLInputElement;
    private readonly class_: ClassField;
    private pause_: ReturnType<typeof setTimeout> | undefined;

    constructor(
        filter: CollectionFilter,
        classes: KnownClasses,
        onEdit: (filter: CollectionFilter) => void,
    ) {
        this.name_ = element('input', {
            type: 'search',
            class: 'input',
            name: 'name',
            value: filter.name,
            placeholder: 'Name contains…',
            autocomplete: 'off',
            maxlength: 256,
        });
        this.class_ = classField(filter.className, classes);
        for (const input of [this.name_, this.class_.input]) {
            input.addEventListener('input', () => {
                clearTimeout(this.pause_);
                this.pause_ = setTimeout(() => onEdit(this.filter), kTypingPauseMs);
            });
        }
        this.node = element(
            'form',
            {
                class: 'filters',
                role: 'search',
                'aria-label': 'Filter the collection',
                submit: (event: Event) => event.preventDefault(),
            },
            element(
                'label',
                { class: 'field' },
                element('span', { class: 'field-label' }, 'Name'),
                this.name_,
            ),
            this.class_.node,
        );
    }

    get filter(): CollectionFilter {
        return { name: this.name_.value.trim(), className: this.class_.input.value.trim() };
    }

    set filter({ name, className }: CollectionFilter) {
        this.name_.value = name;
        this.class_.input.value = className;
    }

    dispose(): void {
        clearTimeout(this.pause_);
        this.class_.dispose();
    }
}

/** All models, page by page, by name and class. */
export function collection(first: CollectionFilter, context: Context): Collection {
    const list = new ModelList(first, context);
    const fields = new FilterFields(first, context.classes, (filter) => {
        if (!sameFilter(filter, list.filter)) {
            context.rewrite({ page: 'home', ...filter });
            list.restart(filter);
        }
    });
    return {
        node: element(
            'section',
            { class: 'collection', 'aria-labelledby': 'collection-title' },
            element(
                'div',
                { class: 'section-head' },
                element('h2', { id: 'collection-title' }, 'Collection ', list.count),
                fields.node,
            ),
            list.message,
            list.grid,
            list.foot,
        ),
        show({ name, className }) {
            const filter = { name, className };
            fields.filter = filter;
            if (!sameFilter(filter, list.filter)) {
                list.restart(filter);
            }
        },
        dispose() {
            fields.dispose();
            list.dispose();
        },
    };
}
