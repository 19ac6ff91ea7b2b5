import { type Client, createClient } from './api/client';
import { homePage } from './gallery/home_page';
import { resultsPage } from './gallery/results_page';
import { reportsPage } from './reports/reports_page';
import type { Context, Page } from './page/context';
import { element, replace } from './page/element';
import { header } from './page/header';
import { KnownClasses } from './page/known_classes';
import { emptyNotice } from './page/problem_notice';
import { formatRoute, kHome, parseRoute, type Route } from './page/routes';

export interface AppOptions {
    client: Client;
}

function missingPage(): Page {
    return {
        node: element(
            'div',
            { class: 'page' },
            emptyNotice(
                'There is no such page.',
                element('a', { href: formatRoute(kHome) }, 'Go to the start page'),
            ),
        ),
        title: 'Not found',
        update: () => false,
        dispose: () => {},
    };
}

function build(route: Route, context: Context): Page {
    switch (route.page) {
        case 'home':
            return homePage(route, context);
        case 'results':
            return resultsPage(route, context);
        case 'reports':
            return reportsPage(context);
        case 'missing':
            return missingPage();
    }
}

/** Builds the page in `root` and follows the address bar. Returns what takes it down again. */
export function startApp(root: HTMLElement, options: Partial<AppOptions> = {}): () => void {
    const { client } = { client: createClient(), ...options };
    const top = header();
    const main = element('main', { id: 'main', tabindex: -1 });
    const status = element('div', { class: 'visually-hidden', role: 'status' });
    const skip = element('button', { class: 'skip', type: 'button' }, 'Skip to the content');
    skip.addEventListener('click', () => main.focus());
    replace(root, skip, top.node, main, status);

    let page: Page | null = null;
    const show = (): void => {
        const route = parseRoute(location.hash);
        top.show(route);
        if (page?.update(route)) {
            return;
        }
        const first = page === null;
        page?.dispose();
        page = build(route, context);
        replace(main, page.node);
        document.title = `${page.title} · Ossuary`;
        if (!first) {
            scrollTo(0, 0);
            // Otherwise the focus would be lost with the link that was followed.
            main.focus({ preventScroll: true });
        }
    };
    const context: Context = {
        client,
        classes: new KnownClasses(),
        upload: null,
        navigate(route) {
            const address = formatRoute(route);
            if (location.hash === address) {
                show();
            } else {
                location.hash = address;
            }
        },
        rewrite(route) {
            history.replaceState(null, '', formatRoute(route));
        },
        announce(message) {
            status.textContent = message;
        },
    };
    addEventListener('hashchange', show);
    show();
    return () => {
        removeEventListener('hashchange', show);
        page?.dispose();
        root.replaceChildren();
    };
}
