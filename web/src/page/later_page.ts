import { codePart } from './code_part';
import type { Page } from './context';
import { element, replace } from './element';
import { problemNotice } from './problem_notice';
import type { Route } from './routes';

export interface LaterPageOptions<R extends Route> {
    route: R;
    title: string;
    /** Fetches the code. */
    load: () => Promise<(route: R) => Page>;
}

/** A page whose code comes only when it is asked for. */
export function laterPage<R extends Route>({ route, title, load }: LaterPageOptions<R>): Page {
    const node = element('div', { 'aria-busy': 'true' });
    let wanted = route;
    let page: Page | null = null;
    let disposed = false;
    const show = async (): Promise<void> => {
        node.setAttribute('aria-busy', 'true');
        try {
            const build = await codePart(load);
            if (disposed) {
                return;
            }
            page = build(wanted);
            replace(node, page.node);
            await page.ready;
        } catch (error) {
            const notice = problemNotice(error, { retry: () => void show() });
            replace(node, element('div', { class: 'page' }, notice));
        } finally {
            node.removeAttribute('aria-busy');
        }
    };
    return {
        node,
        title,
        ready: show(),
        update(next) {
            if (page) {
                return page.update(next);
            }
            if (next.page !== route.page) {
                return false;
            }
            wanted = next as R;
            return true;
        },
        dispose() {
            disposed = true;
            page?.dispose();
        },
    };
}
