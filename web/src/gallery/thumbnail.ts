import { element } from '../page/element';

/** The picture of a model, at the address that the server gave; a quiet placeholder without one. */
export function thumbnail(address: string): HTMLElement {
    // The name stands beside it, so that the picture itself has nothing to add in words.
    const image = element('img', {
        src: address,
        alt: '',
        loading: 'lazy',
        decoding: 'async',
        draggable: 'false',
    });
    const node = element('span', { class: 'thumbnail' }, image);
    image.addEventListener('load', () => node.classList.add('thumbnail-ready'));
    image.addEventListener('error', () => {
        image.remove();
        node.classList.add('thumbnail-missing');
    });
    return node;
}

/** Grey cards in the place of those that are on their way. */
export function skeletonCards(count: number): HTMLElement[] {
    return Array.from({ length: count }, () =>
        element(
            'li',
            { class: 'card card-loading', 'aria-hidden': 'true' },
            element('span', { class: 'thumbnail' }),
            element('span', { class: 'bone' }),
            element('span', { class: 'bone bone-short' }),
        ),
    );
}
