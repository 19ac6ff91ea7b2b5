import { isAbort } from '../api/problem';
import type { ModelPage } from '../api/types';
import type { Context } from '../page/context';
import { element, replace } from '../page/element';
import { formatCount, formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, kHome } from '../page/routes';
import { classField } from './class_field';
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

/** All models, page by page, by name and class. */
export function collection(first: CollectionFilter, context: Context): Collection {
    let filter = { ...first };
    let cursor: string | null = null;
    let shown = 0;
    let running = new AbortController();
    let pause: ReturnType<typeof setTimeout> | undefined;

    const name = element('input', {
        type: 'search',
        class: 'input',
        name: 'name',
        value: filter.name,
        placeholder: 'Name contains…',
        autocomplete: 'off',
        maxlength: 256,
    });
    const className = classField(filter.className, context.classes);
    const count = element('span', { class: 'count' });
    const grid = element('ul', { class: 'grid', 'aria-label': 'Models of the collection' });
    const message = element('div', {});
    const more = element('button', { type: 'button', class: 'button' }, 'Show more');
    const foot = element('div', { class: 'grid-foot', hidden: true }, more);

    const describe = (page: ModelPage): void => {
        count.textContent = formatCount(page.total);
        context.announce(`${formatPlural(page.total, 'model')} in the collection fit the filters`);
        const filtered = filter.name !== '' || filter.className !== '';
        if (page.total === 0) {
            replace(
                message,
                filtered
                    ? emptyNotice(
                          'No model fits these filters.',
                          element('a', { href: formatRoute(kHome) }, 'Show all models'),
                      )
                    : emptyNotice(
                          'The collection is empty.',
                          'Add models with ',
                          element('code', {}, 'ossuary index --index FILE FOLDER'),
                          ' and reload this page.',
                      ),
            );
        }
    };
    const load = async (): Promise<void> => {
        running.abort();
        running = new AbortController();
        const { signal } = running;
        const continued = cursor !== null;
        more.disabled = true;
        message.replaceChildren();
        if (!continued) {
            foot.hidden = true;
            replace(grid, skeletonCards(kCardsWhileLoading));
        }
        try {
            const page = await context.client.models({ ...filter, cursor }, signal);
            if (!continued) {
                grid.replaceChildren();
                shown = 0;
            }
            context.classes.add(page.models.map((model) => model.class));
            const cards = page.models.map(modelCard);
            grid.append(...cards);
            if (continued) {
                cards[0]?.querySelector('a')?.focus();
            }
            shown += cards.length;
            cursor = page.next_cursor;
            foot.hidden = cursor === null;
            more.textContent = `Show more (${formatCount(Math.max(0, page.total - shown))} left)`;
            describe(page);
        } catch (error) {
            if (!isAbort(error)) {
                if (!continued) {
                    grid.replaceChildren();
                }
                replace(message, problemNotice(error, { retry: () => void load() }));
            }
        } finally {
            more.disabled = false;
        }
    };
    const restart = (next: CollectionFilter): void => {
        filter = next;
        cursor = null;
        void load();
    };
    const edited = (): void => {
        clearTimeout(pause);
        pause = setTimeout(() => {
            const next = { name: name.value.trim(), className: className.input.value.trim() };
            if (next.name !== filter.name || next.className !== filter.className) {
                context.rewrite({ page: 'home', ...next });
                restart(next);
            }
        }, kTypingPauseMs);
    };
    name.addEventListener('input', edited);
    className.input.addEventListener('input', edited);
    more.addEventListener('click', () => void load());
    void load();
    return {
        node: element(
            'section',
            { class: 'collection', 'aria-labelledby': 'collection-title' },
            element(
                'div',
                { class: 'section-head' },
                element('h2', { id: 'collection-title' }, 'Collection ', count),
                element(
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
                        name,
                    ),
                    className.node,
                ),
            ),
            message,
            grid,
            foot,
        ),
        show(next) {
            name.value = next.name;
            className.input.value = next.className;
            if (next.name !== filter.name || next.className !== filter.className) {
                restart({ ...next });
            }
        },
        dispose() {
            clearTimeout(pause);
            running.abort();
            className.dispose();
        },
    };
}
