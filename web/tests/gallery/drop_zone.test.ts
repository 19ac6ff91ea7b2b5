import { afterEach, expect, it, vi } from 'vitest';

import { type DropZone, dropZone } from '../../src/gallery/drop_zone';

let zone: DropZone | null = null;

afterEach(() => {
    zone?.dispose();
    zone = null;
});

function drag(type: string, files: File[], types = ['Files']): DragEvent {
    const event = new Event(type, { cancelable: true }) as DragEvent;
    Object.defineProperty(event, 'dataTransfer', { value: { files, types } });
    Object.defineProperty(event, 'relatedTarget', { value: null });
    return event;
}

const kFile = new File(['OFF'], 'a.off');

it('takes a file that is dropped anywhere on the page', () => {
    const onFile = vi.fn();
    zone = dropZone({ onFile });
    const over = drag('dragover', []);
    window.dispatchEvent(over);
    expect(over.defaultPrevented).toBe(true);
    expect(zone.node.classList.contains('drop-zone-over')).toBe(true);
    window.dispatchEvent(drag('drop', [kFile, new File([''], 'b.off')]));
    expect(onFile).toHaveBeenCalledExactlyOnceWith(kFile);
    expect(zone.node.classList.contains('drop-zone-over')).toBe(false);
});

it('leaves other things that are dragged alone', () => {
    const onFile = vi.fn();
    zone = dropZone({ onFile });
    const over = drag('dragover', [], ['text/plain']);
    window.dispatchEvent(over);
    window.dispatchEvent(drag('drop', [], ['text/plain']));
    expect(over.defaultPrevented).toBe(false);
    expect(onFile).not.toHaveBeenCalled();
});

it('takes nothing while it is busy, and everything again after', () => {
    const onFile = vi.fn();
    zone = dropZone({ onFile });
    zone.busy = true;
    window.dispatchEvent(drag('drop', [kFile]));
    expect(onFile).not.toHaveBeenCalled();
    expect(zone.node.querySelector('button')?.disabled).toBe(true);
    zone.busy = false;
    window.dispatchEvent(drag('drop', [kFile]));
    expect(onFile).toHaveBeenCalledOnce();
});

it('takes nothing any more once it is gone', () => {
    const onFile = vi.fn();
    dropZone({ onFile }).dispose();
    window.dispatchEvent(drag('drop', [kFile]));
    expect(onFile).not.toHaveBeenCalled();
});

it('can be used by keyboard: a button opens the file chooser', () => {
    zone = dropZone();
    const input = zone.node.querySelector('input');
    const click = vi.spyOn(input as HTMLInputElement, 'click');
    zone.node.querySelector('button')?.click();
    expect(click).toHaveBeenCalledOnce();
    expect(input?.getAttribute('aria-label')).toBeTruthy();
});

it('offers the files that are read, and says which', () => {
    zone = dropZone();
    const accept = zone.node.querySelector('input')?.accept.split(',');
    for (const extension of ['.off', '.stl', '.obj', '.ply']) {
        expect(accept).toContain(extension);
    }
    expect(zone.node.textContent).toContain('OFF, STL, OBJ, PLY, 3MF, glTF, COLLADA, FBX, STEP');
});
