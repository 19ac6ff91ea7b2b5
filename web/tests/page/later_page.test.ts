import { expect, it, vi } from 'vitest';

import type { Page } from '../../src/page/context';
import { laterPage } from '../../src/page/later_page';
import { type Route, resultsOf } from '../../src/page/routes';

function madePage(): Page {
    const node = document.createElement('p');
    node.textContent = 'here';
    return {
        node,
        title: 'x',
        ready: Promise.resolve(),
        update: () => true,
        dispose: vi.fn(),
    };
}

const kReports = { page: 'reports' } as const;

it('shows the page once its code is there, as it is asked for by then', async () => {
    const routes: Route[] = [];
    const page = laterPage({
        route: resultsOf({ kind: 'model', id: 7 }),
        title: 'Results',
        load: async () => (route) => {
            routes.push(route);
            return madePage();
        },
    });
    expect(page.node.getAttribute('aria-busy')).toBe('true');
    const other = resultsOf({ kind: 'model', id: 8 });
    expect(page.update(other)).toBe(true);
    expect(page.update(kReports)).toBe(false);
    await page.ready;
    expect(page.node.textContent).toBe('here');
    expect(page.node.hasAttribute('aria-busy')).toBe(false);
    expect(routes).toEqual([other]);
});

it('says that the code did not arrive', async () => {
    const load = () => Promise.reject(new TypeError('no chunk'));
    const page = laterPage({ route: kReports, title: 'Reports', load });
    await page.ready;
    expect(page.node.querySelector('.notice-code')?.textContent).toBe('page_part');
    expect(page.node.hasAttribute('aria-busy')).toBe(false);
});

it('builds nothing of what arrives too late', async () => {
    const build = vi.fn(madePage);
    const page = laterPage({ route: kReports, title: 'Reports', load: async () => build });
    page.dispose();
    await page.ready;
    expect(build).not.toHaveBeenCalled();
});
