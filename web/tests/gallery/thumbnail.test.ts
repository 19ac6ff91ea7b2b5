import { expect, it } from 'vitest';

import { skeletonCards, thumbnail } from '../../src/gallery/thumbnail';

it('shows the server’s picture once it is there', () => {
    const node = thumbnail('/v1/models/7/thumbnail.png?v=1');
    const image = node.querySelector('img');
    expect(image?.getAttribute('src')).toBe('/v1/models/7/thumbnail.png?v=1');
    expect(image?.hasAttribute('alt')).toBe(true);
    image?.dispatchEvent(new Event('load'));
    expect(node.classList.contains('thumbnail-ready')).toBe(true);
});

it('replaces a picture that the server has not by a quiet placeholder', () => {
    const node = thumbnail('/v1/models/7/thumbnail.png?v=1');
    node.querySelector('img')?.dispatchEvent(new Event('error'));
    expect(node.querySelector('img')).toBeNull();
    expect(node.classList.contains('thumbnail-missing')).toBe(true);
});

it('hides the cards of what is on its way from screen readers', () => {
    const cards = skeletonCards(3);
    expect(cards).toHaveLength(3);
    expect(cards.every((card) => card.getAttribute('aria-hidden') === 'true')).toBe(true);
});
