import { beforeEach, expect, it } from 'vitest';

import { Visits } from '../../src/page/visits';

beforeEach(() => history.replaceState(null, '', '#/'));

it('knows what led to a step, also after the page was loaded anew', () => {
    const visits = new Visits();
    expect(visits.from).toBeNull();
    visits.push('#/models/7', '#/');
    expect(visits.from).toBe('#/');
    expect(location.hash).toBe('#/models/7');
    visits.replace('#/models/7?pose=1');
    expect(visits.from).toBe('#/');
    expect(new Visits().from).toBe('#/');
});

it('keeps where each step was left', () => {
    const visits = new Visits();
    const first = history.state;
    visits.leave({ y: 300, link: '#/models/7' });
    visits.push('#/models/7', '#/');
    expect(visits.place).toBeUndefined();
    // As the browser's way back would.
    history.replaceState(first, '', '#/');
    visits.follow('#/models/7');
    expect(visits.place).toEqual({ y: 300, link: '#/models/7' });
    expect(visits.from).toBeNull();
});

it('gives steps of an earlier load other numbers than those of this one', () => {
    history.replaceState({ ossuary: { visit: 41, from: null } }, '', '#/');
    const visits = new Visits();
    visits.leave({ y: 5, link: null });
    visits.push('#/reports', '#/');
    expect(history.state).toEqual({ ossuary: { visit: 42, from: '#/' } });
    expect(visits.place).toBeUndefined();
});
