import { afterEach, expect, it } from 'vitest';

import { onThemeChange, readAccent, readViewerTheme } from '../../src/viewer/theme';

afterEach(() => {
    document.documentElement.removeAttribute('style');
});

it('takes the style sheet’s colours, and its own where there are none', () => {
    expect(readViewerTheme().unmatched).toMatch(/^#[0-9a-f]{6}$/);
    const { style } = document.documentElement;
    style.setProperty('--viewer-unmatched', ' #123456 ');
    style.setProperty('--viewer-rim-opacity', '0.25');
    style.setProperty('--viewer-accent', '#abcdef');
    expect(readViewerTheme().unmatched).toBe('#123456');
    expect(readViewerTheme().surface.rimOpacity).toBe(0.25);
    expect(readAccent()).toBe('#abcdef');
});

it('can be listened to and left', () => {
    expect(() => onThemeChange(() => {})()).not.toThrow();
});
