import { element } from './element';

/** Lets the browser save something under a name. */
export function saveFile(name: string, content: Blob): void {
    const href = URL.createObjectURL(content);
    element('a', { href, download: name }).click();
    // The browser has taken it by then.
    setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

export function saveText(name: string, type: string, text: string): void {
    saveFile(name, new Blob([text], { type }));
}
