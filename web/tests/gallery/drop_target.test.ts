import { afterEach, expect, it, vi } from 'vitest';

import { type DropTarget, dropTarget } from '../../src/gallery/drop_target';
import { settled } from '../sample';

let target: DropTarget | null = null;

afterEach(() => {
    target?.dispose();
    target = null;
});

function opened() {
    const onFiles = vi.fn();
    const onProblem = vi.fn();
    target = dropTarget({ onFiles, onProblem });
    return { onFiles, onProblem, node: target.node };
}

interface Held {
    files: File[];
    types?: string[];
    items?: unknown[];
}

function transfer(type: string, { files, types = ['Files'], items = [] }: Held): Event {
    const event = new Event(type, { cancelable: true });
    const name = type === 'paste' ? 'clipboardData' : 'dataTransfer';
    Object.defineProperty(event, name, { value: { files, types, items } });
    Object.defineProperty(event, 'relatedTarget', { value: null });
    return event;
}

const kFiles = [new File(['OFF'], 'a.off'), new File(['OFF'], 'b.off')];

/** What browsers say of a folder that is dropped. */
function folder(name: string, entries: unknown[]): unknown {
    let given = false;
    return {
        name,
        isDirectory: true,
        createReader: () => ({
            readEntries(resolve: (some: unknown[]) => void) {
                const some = given ? [] : entries;
                given = true;
                resolve(some);
            },
        }),
    };
}

function fileEntry(name: string): unknown {
    const file = new File([''], name);
    return { name, isDirectory: false, file: (resolve: (file: File) => void) => resolve(file) };
}

function asItem(entry: unknown): unknown {
    return { webkitGetAsEntry: () => entry };
}

it('takes all files that are dropped or pasted anywhere, and shows that it would', async () => {
    const { onFiles, node } = opened();
    const over = transfer('dragover', { files: [] });
    window.dispatchEvent(over);
    expect(over.defaultPrevented).toBe(true);
    expect(node.classList.contains('drop-veil-on')).toBe(true);
    window.dispatchEvent(transfer('drop', { files: kFiles }));
    expect(node.classList.contains('drop-veil-on')).toBe(false);
    window.dispatchEvent(transfer('paste', { files: kFiles }));
    await settled();
    expect(onFiles.mock.calls).toEqual([[kFiles], [kFiles]]);
});

it('leaves other things that are dragged or pasted alone', async () => {
    const { onFiles } = opened();
    for (const type of ['dragover', 'drop', 'paste']) {
        const event = transfer(type, { files: [], types: ['text/plain'] });
        window.dispatchEvent(event);
        expect(event.defaultPrevented).toBe(false);
    }
    await settled();
    expect(onFiles).not.toHaveBeenCalled();
});

it('takes the models in a folder and below it, in their natural order', async () => {
    const { onFiles } = opened();
    const below = folder('more', [fileEntry('b10.stl'), fileEntry('b9.STL')]);
    const top = folder('models', [fileEntry('z.off'), below, fileEntry('notes.doc')]);
    const files = [new File([''], 'models')];
    window.dispatchEvent(transfer('drop', { files, items: [asItem(top)] }));
    await settled();
    const taken = onFiles.mock.calls[0]?.[0] as File[];
    expect(taken.map(({ name }) => name)).toEqual(['b9.STL', 'b10.stl', 'z.off']);
});

it('says of a folder without models that there are none', async () => {
    const { onFiles, onProblem } = opened();
    const empty = folder('papers', [fileEntry('notes.doc')]);
    window.dispatchEvent(transfer('drop', { files: [], items: [asItem(empty)] }));
    await settled();
    expect(onFiles).not.toHaveBeenCalled();
    expect(onProblem.mock.calls[0]?.[0]).toMatchObject({ code: 'local_folder' });
});

it('takes nothing any more once it is gone', async () => {
    const { onFiles } = opened();
    target?.dispose();
    window.dispatchEvent(transfer('drop', { files: kFiles }));
    await settled();
    expect(onFiles).not.toHaveBeenCalled();
});
