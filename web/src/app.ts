import { type Client, createClient } from './api/client';
import { kSearchDefaults } from './api/search_parameters';
import { dropTarget } from './gallery/drop_target';
import { fileChooser } from './gallery/file_chooser';
import { homePage } from './gallery/home_page';
import { uploadTray } from './gallery/upload_tray';
import type { Context, Page } from './page/context';
import { element, replace } from './page/element';
import { header } from './page/header';
import { KnownFacets } from './page/known_facets';
import { laterPage } from './page/later_page';
import { formatPlural } from './page/format';
import { emptyNotice } from './page/problem_notice';
import { Recent } from './page/recent';
import { formatRoute, kHome, parseRoute, type Route, resultsOf } from './page/routes';
import { Selection } from './page/selection';
import { type Upload, Uploads } from './page/uploads';
import { Visits } from './page/visits';
import { say } from './words/say';

export interface AppOptions {
    client: Client;
}

const kAnswers = 12;
/** The collection may change behind an answer that is kept for the way back. */
const kAnswersMs = 5 * 60_000;

function missingPage(): Page {
    return {
        node: element(
            'div',
            { class: 'page' },
            element('h1', { class: 'visually-hidden' }, say('Not found')),
            emptyNotice(
                say('There is no such page.'),
                element('a', { href: formatRoute(kHome) }, say('Go to the start page')),
            ),
        ),
        title: say('Not found'),
        ready: Promise.resolve(),
        update: () => false,
        dispose: () => {},
    };
}

const resultsCode = () => import('./gallery/results_page');

function build(route: Route, context: Context): Page {
    switch (route.page) {
        case 'home':
            return homePage(route, context);
        // The start page is there before the code of what it leads to.
        case 'results':
            return laterPage({
                route,
                title: say('Results'),
                load: async () => {
                    const { resultsPage } = await resultsCode();
                    return (to) => resultsPage(to, context);
                },
            });
        case 'reports':
            return laterPage({
                route,
                title: say('Reports'),
                load: async () => {
                    const { reportsPage } = await import('./reports/reports_page');
                    return () => reportsPage(context);
                },
            });
        case 'manage':
            return laterPage({
                route,
                title: say('Manage'),
                load: async () => {
                    const { managePage } = await import('./manage/manage_page');
                    return () => managePage(context);
                },
            });
        case 'missing':
            return missingPage();
    }
}

function linkWithFocus(): string | null {
    return document.activeElement?.getAttribute('href') ?? null;
}

/** The page that is shown, and the way from one to the next. */
class App {
    readonly main = element('main', { id: 'main', tabindex: -1 });
    readonly status = element('div', { class: 'visually-hidden', role: 'status' });
    readonly context: Context;
    private readonly visits_ = new Visits();
    private readonly onShow_: (route: Route) => void;
    private page_: Page | null = null;
    private address_ = '';

    constructor(client: Client, onShow: (route: Route) => void) {
        this.onShow_ = onShow;
        this.context = {
            client,
            facets: new KnownFacets(client),
            uploads: new Uploads(client),
            selection: new Selection(),
            answers: new Recent(kAnswers, kAnswersMs),
            parameters: kSearchDefaults,
            navigate: (route) => this.navigate(route),
            replace: (route) => {
                this.context.rewrite(route);
                this.show();
            },
            back: (fallback) => {
                const { from } = this.visits_;
                if (from !== null && parseRoute(from).page === 'results') {
                    history.back();
                } else {
                    this.context.replace(fallback);
                }
            },
            rewrite: (route) => {
                this.visits_.replace(formatRoute(route));
                this.address_ = location.hash;
            },
            entitle: (title) => {
                document.title = `${title} · Ossuary`;
            },
            announce: (message) => {
                this.status.textContent = message;
            },
        };
        this.context.uploads.onDone = (upload: Upload) => this.showUpload(upload);
    }

    /** After the browser has gone to another address. */
    readonly follow = (): void => {
        if (location.hash === this.address_) {
            return;
        }
        this.leave();
        this.visits_.follow(this.address_);
        this.show();
    };

    show(): void {
        this.address_ = location.hash;
        const route = parseRoute(this.address_);
        this.onShow_(route);
        if (this.page_?.update(route)) {
            return;
        }
        const first = this.page_ === null;
        this.page_?.dispose();
        const page = build(route, this.context);
        this.page_ = page;
        replace(this.main, page.node);
        this.context.entitle(page.title);
        if (!first) {
            // Otherwise the focus would be lost with the link that was followed.
            this.main.focus({ preventScroll: true });
        }
        void this.settle(page);
    }

    dispose(): void {
        this.page_?.dispose();
    }

    private navigate(route: Route): void {
        const address = formatRoute(route);
        if (location.hash !== address) {
            this.leave();
            this.visits_.push(address, this.address_);
        }
        this.show();
    }

    private leave(): void {
        this.visits_.leave({ y: scrollY, link: linkWithFocus() });
    }

    /** To where the page was left, should it have been seen before; else to its beginning. */
    private async settle(page: Page): Promise<void> {
        const { place } = this.visits_;
        scrollTo(0, 0);
        if (!place) {
            return;
        }
        await page.ready;
        if (this.page_ !== page) {
            return;
        }
        scrollTo(0, place.y);
        if (place.link !== null && document.activeElement === this.main) {
            this.main
                .querySelector<HTMLElement>(`a[href="${CSS.escape(place.link)}"]`)
                ?.focus({ preventScroll: true });
        }
    }

    private showUpload({ name, token, answer }: Upload): void {
        const hits = answer?.result.hits.length ?? 0;
        this.context.announce(
            say('{hits} for {name}', { hits: formatPlural(hits, 'hit', 'hits'), name }),
        );
        this.navigate(
            resultsOf(
                token === null ? { kind: 'upload' } : { kind: 'query', token },
                answer?.parameters,
            ),
        );
    }
}

/** Once nothing else is to be done. */
function requestIdle(work: () => void): void {
    if ('requestIdleCallback' in globalThis) {
        requestIdleCallback(work);
    } else {
        setTimeout(work, 0);
    }
}

/** Builds the page in `root` and follows the address bar. Returns what takes it down again. */
export function startApp(root: HTMLElement, options: Partial<AppOptions> = {}): () => void {
    const { client } = { client: createClient(), ...options };
    const take = (files: File[]): void => app.context.uploads.take(files, app.context.parameters);
    const chooser = fileChooser({ label: say('Search with a file'), onFiles: take });
    const top = header(chooser.node);
    const app = new App(client, (route) => top.show(route));
    const tray = uploadTray(app.context);
    // What cards can do besides leading somewhere is there soon after them.
    const extras = element('div', {});
    let endExtras: () => void = () => {};
    let over = false;
    const addExtras = async (): Promise<void> => {
        const { cardExtras } = await import('./gallery/card_extras');
        if (!over) {
            endExtras = cardExtras(app.context, { cards: app.main, place: extras });
        }
    };
    const target = dropTarget({ onFiles: take, onProblem: (error) => tray.complain(error) });
    const skip = element('button', { class: 'skip', type: 'button' }, say('Skip to the content'));
    skip.addEventListener('click', () => app.main.focus());
    replace(root, skip, top.node, tray.node, app.main, extras, target.node, app.status);
    addEventListener('hashchange', app.follow);
    app.show();
    // Most visits lead there; should it fail now, it is asked for again.
    requestIdle(() => {
        void resultsCode().catch(() => {});
        void addExtras().catch(() => {});
    });
    return () => {
        removeEventListener('hashchange', app.follow);
        target.dispose();
        tray.dispose();
        over = true;
        endExtras();
        app.dispose();
        root.replaceChildren();
    };
}
