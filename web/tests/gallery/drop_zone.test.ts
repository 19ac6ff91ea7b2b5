import { expect, it, vi } from 'vitest';

import { dropZone } from '../../src/gallery/drop_zone';

it('can be used by keyboard: a button opens the file chooser, which takes several', () => {
    const onFiles = vi.fn();
    const node = dropZone(onFiles);
    const input = node.querySelector('input') as HTMLInputElement;
    const click = vi.spyOn(input, 'click');
    node.querySelector('button')?.click();
    expect(click).toHaveBeenCalledOnce();
    expect(input.multiple).toBe(true);
    const files = [new File([''], 'a.off'), new File([''], 'b.off')];
    Object.defineProperty(input, 'files', { value: files });
    input.dispatchEvent(new Event('change'));
    expect(onFiles).toHaveBeenCalledExactlyOnceWith(files);
});

it('offers the files that are read, and says which', () => {
    const node = dropZone(() => {});
    const accept = node.querySelector('input')?.accept.split(',');
    for (const extension of ['.off', '.stl', '.obj', '.ply']) {
        expect(accept).toContain(extension);
    }
    expect(node.textContent).toContain('OFF, STL, OBJ, PLY, 3MF, glTF, COLLADA, FBX, STEP');
});
