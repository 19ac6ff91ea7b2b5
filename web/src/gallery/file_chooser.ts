import { element } from '../page/element';
import { kAccepted } from './model_endings';
import { say } from '../words/say';

export interface FileChooserOptions {
    label: string;
    /** Besides those of every button. */
    className: string;
    onFiles: (files: File[]) => void;
}

const kDefaults: FileChooserOptions = { label: '', className: '', onFiles: () => {} };

/** A button that asks for files. */
export function fileChooser(options: Partial<FileChooserOptions>): { node: HTMLElement } {
    const { label, className, onFiles } = { ...kDefaults, ...options };
    const input = element('input', {
        type: 'file',
        multiple: true,
        hidden: true,
        accept: kAccepted,
        'aria-label': say('Model files'),
    });
    input.addEventListener('change', () => {
        const files = [...(input.files ?? [])];
        // The same file may be chosen again, after it has been mended.
        input.value = '';
        if (files.length > 0) {
            onFiles(files);
        }
    });
    const button = element(
        'button',
        { type: 'button', class: `button ${className}`.trim(), click: () => input.click() },
        label,
    );
    return { node: element('span', { class: 'file-chooser' }, button, input) };
}
