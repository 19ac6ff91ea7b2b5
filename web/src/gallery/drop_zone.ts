import { append, element, svg } from '../page/element';

export interface DropZoneOptions {
    onFile: (file: File) => void;
    /** Said below the headline. */
    hint: string;
}

const kDefaults: DropZoneOptions = {
    onFile: () => {},
    hint: 'OFF, STL, OBJ, PLY, 3MF, glTF, COLLADA, FBX, STEP …, points (XYZ) or a volume, packed or not. Nothing is stored.',
};

export interface DropZone {
    node: HTMLElement;
    /** While true, nothing can be dropped or chosen. */
    busy: boolean;
    dispose(): void;
}

function picture(): SVGElement {
    return svg(
        'svg',
        { class: 'drop-picture', viewBox: '0 0 96 72', 'aria-hidden': 'true' },
        svg('path', {
            class: 'drop-body',
            d: 'M10 63C5 45 12 27 30 24c9-5 25-5 35-3 4-8 9-16 20-15 6 1 7 6 2 9-5 2-7 8-9 14 4 10 8 22 9 34h-9c-1-9-4-17-9-22-8 4-17 5-25 3-3 5-3 12-3 19h-9c0-9 0-14-2-20-6 3-10 10-11 20Z',
        }),
        svg('path', {
            class: 'drop-bone',
            d: 'M14 61C13 46 18 36 33 31S58 32 70 27M36 33C37 44 37 52 37 61M70 27C76 37 80 48 81 61M70 27C73 18 77 13 84 10',
        }),
        ...[
            [33, 31],
            [70, 27],
            [84, 10],
            [14, 61],
            [37, 61],
            [81, 61],
        ].map(([cx, cy]) => svg('circle', { class: 'drop-joint', cx, cy, r: 3 })),
    );
}

function holdsFiles(event: DragEvent): boolean {
    return event.dataTransfer?.types.includes('Files') ?? false;
}

/**
 * Takes one file by dropping it anywhere on the page, or by the button inside. The first of several
 * files is taken.
 */
export function dropZone(options: Partial<DropZoneOptions> = {}): DropZone {
    const { onFile, hint } = { ...kDefaults, ...options };
    const input = element('input', {
        type: 'file',
        class: 'visually-hidden',
        id: 'model-file',
        accept: '.off,.coff,.noff,.stoff,.stl,.obj,.ply,.xyz,.pts,.asc,.3mf,.gltf,.glb,.dae,.x3d,.amf,.fbx,.step,.stp,.iges,.igs,.nrrd,.nii,.binvox,.npy,.gz,.zip,model/*,text/plain',
        'aria-label': 'Model file',
        tabindex: -1,
    });
    const button = element('button', { type: 'button', class: 'button button-primary' });
    append(button, 'Choose a model');
    const node = element(
        'div',
        { class: 'drop-zone' },
        picture(),
        element('p', { class: 'drop-title' }, 'Drop a 3D model here'),
        button,
        element('p', { class: 'fine' }, hint),
        input,
    );

    let busy = false;
    const take = (files: FileList | null | undefined): void => {
        const file = files?.[0];
        if (file && !busy) {
            onFile(file);
        }
    };
    button.addEventListener('click', () => input.click());
    input.addEventListener('change', () => {
        take(input.files);
        // The same file may be chosen again, after it has been mended.
        input.value = '';
    });

    const undo = new AbortController();
    const { signal } = undo;
    const highlight = (on: boolean): void => {
        node.classList.toggle('drop-zone-over', on && !busy);
    };
    addEventListener(
        'dragover',
        (event) => {
            if (holdsFiles(event)) {
                event.preventDefault();
                highlight(true);
            }
        },
        { signal },
    );
    addEventListener(
        'dragleave',
        (event) => {
            if (event.relatedTarget === null) {
                highlight(false);
            }
        },
        { signal },
    );
    addEventListener(
        'drop',
        (event) => {
            highlight(false);
            if (holdsFiles(event)) {
                event.preventDefault();
                take(event.dataTransfer?.files);
            }
        },
        { signal },
    );
    return {
        node,
        get busy() {
            return busy;
        },
        set busy(value) {
            busy = value;
            button.disabled = value;
            input.disabled = value;
            node.classList.toggle('drop-zone-busy', value);
        },
        dispose: () => undo.abort(),
    };
}
