import type { kGerman } from './german';

export const kLanguages = ['en', 'de'] as const;
export type Language = (typeof kLanguages)[number];

/** What the page says, in English; every one of them has its line in the table of {@link kGerman}. */
export type Text = keyof typeof kGerman;

export type Values = Readonly<Record<string, string | number>>;

let language: Language = 'en';
let table: Readonly<Record<string, string>> | null = null;

/** The language that {@link say} speaks. */
export function spokenLanguage(): Language {
    return language;
}

function filled(text: string, values: Values): string {
    return text.replace(/\{(\w+)\}/g, (all, name: string) => String(values[name] ?? all));
}

/** A sentence in the page's language; `{name}` in it is replaced by the value of that name. */
export function say(text: Text, values: Values = {}): string {
    return filled(table?.[text] ?? text, values);
}

/** A name that the server gave, where the page has a word for it; else as it is. */
export function sayName(name: string): string {
    return table?.[name] ?? name;
}

const kStored = 'ossuary.language';

function isLanguage(value: unknown): value is Language {
    return (kLanguages as readonly unknown[]).includes(value);
}

/** What was chosen on this browser, else what the browser asks for, else English. */
export function wantedLanguage(): Language {
    try {
        const stored = localStorage.getItem(kStored);
        if (isLanguage(stored)) {
            return stored;
        }
    } catch {
        // A browser that keeps nothing for pages.
    }
    const asked = navigator.languages ?? [navigator.language];
    return asked.map((each) => each.slice(0, 2).toLowerCase()).find(isLanguage) ?? 'en';
}

export function keepLanguage(chosen: Language): void {
    try {
        localStorage.setItem(kStored, chosen);
    } catch {
        // Then it holds until the page is loaded anew.
    }
}

/** English is in the code; the table of another language is fetched before anything is shown. */
export async function speak(wanted: Language): Promise<void> {
    table = wanted === 'de' ? (await import('./german')).kGerman : null;
    language = wanted;
    document.documentElement.lang = wanted;
}
