import { expect, it } from 'vitest';

import { header } from '../../src/page/header';
import { kHome, resultsOf } from '../../src/page/routes';

it('marks the page that is shown, and only that', () => {
    const { node, show } = header(document.createElement('button'));
    const current = () =>
        [...node.querySelectorAll('nav a[aria-current]')].map((link) => link.textContent);
    show(kHome);
    expect(current()).toEqual(['Search']);
    show({ page: 'reports' });
    expect(current()).toEqual(['Reports']);
    show(resultsOf({ kind: 'upload' }));
    expect(current()).toEqual(['Search']);
    show({ page: 'manage' });
    expect(current()).toEqual(['Manage']);
    show({ page: 'missing', path: '/x' });
    expect(current()).toEqual([]);
});
