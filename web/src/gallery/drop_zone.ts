import { element, svg } from '../page/element';
import { fileChooser } from './file_chooser';
import { type Text, say } from '../words/say';

const kHint: Text =
    'OFF, STL, OBJ, PLY, 3MF, glTF, COLLADA, FBX, STEP …, points (XYZ) or a volume, packed or not; several at once, or a folder. Nothing is stored on a disk.';

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

/** Says that files can be dropped, and asks for some; drops are taken wherever they fall. */
export function dropZone(onFiles: (files: File[]) => void): HTMLElement {
    const chooser = fileChooser({
        label: say('Choose a model'),
        className: 'button-primary',
        onFiles,
    });
    return element(
        'div',
        { class: 'drop-zone' },
        picture(),
        element('p', { class: 'drop-title' }, say('Drop a 3D model here')),
        chooser.node,
        element('p', { class: 'fine' }, say(kHint)),
    );
}
