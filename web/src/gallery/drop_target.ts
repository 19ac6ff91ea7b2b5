import { element } from '../page/element';
import { filesOf } from './dropped_files';
import { say } from '../words/say';

export interface DropTargetOptions {
    onFiles: (files: File[]) => void;
    /** What was dropped cannot be read. */
    onProblem: (error: unknown) => void;
}

export interface DropTarget {
    /** Lies over the page while files are held over it. */
    node: HTMLElement;
    dispose(): void;
}

function holdsFiles(transfer: DataTransfer | null): transfer is DataTransfer {
    return transfer?.types.includes('Files') ?? false;
}

/** Takes files and folders that are dropped anywhere in the window, or pasted. */
export function dropTarget({ onFiles, onProblem }: DropTargetOptions): DropTarget {
    // As a popover it lies over open dialogs too.
    const node = element(
        'div',
        { class: 'drop-veil', popover: 'manual', 'aria-hidden': 'true' },
        element('p', {}, say('Drop to search with it')),
    );
    let over = false;
    const veil = (on: boolean): void => {
        if (on !== over) {
            over = on;
            node.classList.toggle('drop-veil-on', on);
            node[on ? 'showPopover' : 'hidePopover']?.();
        }
    };
    const take = async (transfer: DataTransfer): Promise<void> => {
        try {
            onFiles(await filesOf(transfer));
        } catch (error) {
            onProblem(error);
        }
    };
    const undo = new AbortController();
    const { signal } = undo;
    const drag = (event: DragEvent): void => {
        if (holdsFiles(event.dataTransfer)) {
            event.preventDefault();
            veil(true);
        }
    };
    addEventListener('dragenter', drag, { signal });
    addEventListener('dragover', drag, { signal });
    addEventListener(
        'dragleave',
        (event) => {
            // Out of the window, not just off one element.
            if (event.relatedTarget === null) {
                veil(false);
            }
        },
        { signal },
    );
    addEventListener(
        'drop',
        (event) => {
            veil(false);
            if (holdsFiles(event.dataTransfer)) {
                event.preventDefault();
                void take(event.dataTransfer);
            }
        },
        { signal },
    );
    addEventListener(
        'paste',
        (event) => {
            if (holdsFiles(event.clipboardData)) {
                event.preventDefault();
                void take(event.clipboardData);
            }
        },
        { signal },
    );
    return { node, dispose: () => undo.abort() };
}
