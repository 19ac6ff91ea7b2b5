import { describe, expect, it, vi } from 'vitest';

import { append, element, replace, svg } from '../../src/page/element';

describe('element', () => {
    it('never reads text as markup', () => {
        const hostile = '<img src=x onerror=alert(1)>';
        const node = element('p', { title: hostile }, hostile, [hostile]);
        expect(node.children).toHaveLength(0);
        expect(node.textContent).toBe(hostile + hostile);
        expect(node.getAttribute('title')).toBe(hostile);
    });

    it('leaves out what is not there', () => {
        const node = element(
            'p',
            { hidden: false, title: null, lang: undefined, draggable: true },
            false,
            null,
            undefined,
            0,
            '',
        );
        expect(node.getAttributeNames()).toEqual(['draggable']);
        expect(node.textContent).toBe('0');
    });

    it('listens to events of a function’s name', () => {
        const click = vi.fn();
        const node = element('button', { click });
        node.click();
        expect(click).toHaveBeenCalledOnce();
        expect(node.hasAttribute('click')).toBe(false);
    });

    it('sets CSS variables', () => {
        expect(element('i', { '--share': '0.5' }).style.getPropertyValue('--share')).toBe('0.5');
    });
});

describe('svg', () => {
    it('makes elements of the SVG namespace', () => {
        expect(svg('circle', { r: 3 }).namespaceURI).toBe('http://www.w3.org/2000/svg');
    });
});

describe('append and replace', () => {
    it('keep the order of nested lists', () => {
        const node = element('p', {}, 'a');
        append(node, 'b', ['c', ['d']]);
        expect(node.textContent).toBe('abcd');
        replace(node, 'e');
        expect(node.textContent).toBe('e');
    });
});
