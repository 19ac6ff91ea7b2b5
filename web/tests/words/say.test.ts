import { afterEach, expect, it, vi } from 'vitest';

import { kGerman } from '../../src/words/german';
import {
    keepLanguage,
    say,
    sayName,
    speak,
    spokenLanguage,
    wantedLanguage,
} from '../../src/words/say';

afterEach(async () => {
    vi.restoreAllMocks();
    localStorage.clear();
    await speak('en');
});

it('says English by itself and German from its table, with what is filled in', async () => {
    expect(say('{count} selected', { count: 3 })).toBe('3 selected');
    await speak('de');
    expect(say('{count} selected', { count: 3 })).toBe('3 ausgewählt');
    expect(document.documentElement.lang).toBe('de');
    expect(spokenLanguage()).toBe('de');
});

it('leaves names that it does not know as they are', async () => {
    await speak('de');
    expect(sayName('chair_42')).toBe('chair_42');
});

it('speaks what was chosen, else the first language of the browser that it knows, else English', () => {
    const asked = vi.spyOn(navigator, 'languages', 'get');
    asked.mockReturnValue(['fr-FR', 'de-AT', 'en']);
    expect(wantedLanguage()).toBe('de');
    asked.mockReturnValue(['fr']);
    expect(wantedLanguage()).toBe('en');
    keepLanguage('de');
    expect(wantedLanguage()).toBe('de');
    localStorage.setItem('ossuary.language', 'klingon');
    expect(wantedLanguage()).toBe('en');
});

it('has in both languages the same things to fill in, and nothing left without words', () => {
    const holes = (text: string) => [...text.matchAll(/\{\w+\}/g)].map(([hole]) => hole).sort();
    for (const [english, german] of Object.entries(kGerman)) {
        expect(german.trim()).not.toBe('');
        expect([english, holes(german)]).toEqual([english, holes(english)]);
    }
});
