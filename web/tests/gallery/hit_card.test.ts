import { Selection } from '../../src/page/selection';
import { expect, it } from 'vitest';

import { hitCard } from '../../src/gallery/hit_card';
import { hit } from '../sample';

it('shows rank, name, class and distance and leads to the comparison', () => {
    const card = hitCard(hit(2, { name: 'camel', class: 'fourleg', distance: 0.1234 }), {
        href: '#/models/7/hits/102',
        like: { build: '#b', pose: '#p' },
        partNames: ['skeleton', 'moments'],
        nearness: null,
        selection: new Selection(),
    });
    const link = card.querySelector('a');
    expect(link?.getAttribute('href')).toBe('#/models/7/hits/102');
    expect(link?.textContent).toContain('Rank 2');
    expect(link?.textContent).toContain('camel');
    expect(link?.textContent).toContain('fourleg');
    expect(link?.textContent).toContain('Distance 0.123');
});

it('says in a word how near it is, and in a number on demand', () => {
    const options = { href: '#', like: { build: '#b', pose: '#p' }, partNames: [] };
    const card = hitCard(hit(1, { distance: 0.3 }), {
        ...options,
        nearness: 'related',
        selection: new Selection(),
    });
    const figure = card.querySelector('.number');
    expect(figure?.textContent).toBe('Distance related');
    expect(figure?.getAttribute('title')).toContain('0.300');
});

it('says how many copies it stands for, and where it lies', () => {
    const options = { href: '#', like: { build: '#b', pose: '#p' }, partNames: [] };
    const card = hitCard(hit(1, { copies: 144 }), {
        ...options,
        nearness: null,
        selection: new Selection(),
    });
    expect(card.querySelector('.card-copies')?.textContent).toBe(' ×145');
    expect(card.querySelector('.card-file')?.textContent).toBe('chairs');
});

it('draws no bar where all distances are zero', () => {
    const card = hitCard(hit(1, { distance: 0, parts: {} }), {
        href: '#',
        like: { build: '#b', pose: '#p' },
        partNames: [],
        nearness: 'same',
        selection: new Selection(),
    });
    const bar = card.querySelector<HTMLElement>('.parts-bar');
    expect(bar?.style.getPropertyValue('--length')).toBe('0.0000');
});

it('shows how far the hit is in build and in pose, and leads to its likes in either', () => {
    const options = {
        href: '#',
        like: { build: '#b', pose: '#p' },
        partNames: [],
        nearness: 'far' as const,
        selection: new Selection(),
    };
    const card = hitCard(hit(1, { build_difference: 0.4, pose_difference: 3 }), options);
    const bars = [...card.querySelectorAll<HTMLElement>('.difference-bar')].map((bar) =>
        Number(bar.style.getPropertyValue('--share')),
    );
    expect(bars).toEqual([0.2, 1]);
    const links = [...card.querySelectorAll<HTMLElement>('.like-link')];
    expect(links.map((link) => [link.textContent, link.getAttribute('href')])).toEqual([
        ['Same build', '#b'],
        ['Same pose', '#p'],
    ]);
    const unknown = hit(1, { build_difference: null, pose_difference: null });
    expect(hitCard(unknown, options).querySelector('.differences')).toBeNull();
});
