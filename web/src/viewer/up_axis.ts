import { Group } from 'three';

import type { UpAxis } from '../api/elements';
import { element } from '../page/element';
import { say } from '../words/say';

/** What is offered; x too where a file says so, which few do. */
const kAxes: readonly UpAxis[] = ['y', 'z'];

const kQuarterTurn = Math.PI / 2;

/** A model's place in a scene whose y axis points up. */
export class Stand extends Group {
    /** Turns what stands here so that this axis of the file points up. */
    set upAxis(up: UpAxis) {
        this.rotation.set(up === 'z' ? -kQuarterTurn : 0, 0, up === 'x' ? kQuarterTurn : 0);
        this.updateMatrixWorld(true);
    }
}

/** Buttons that say which axis of the file points up in a picture, and change it. */
export function upControl(first: UpAxis, onChange: (up: UpAxis) => void): HTMLElement {
    const axes = first === 'x' ? (['x', ...kAxes] as const) : kAxes;
    const buttons = axes.map((axis) => {
        const button = element('button', {
            type: 'button',
            value: axis,
            'aria-pressed': String(axis === first),
            title: say('Show the model with its {axis} axis up', { axis }),
        });
        button.append(say('{axis} up', { axis }));
        button.addEventListener('click', () => {
            for (const each of buttons) {
                each.setAttribute('aria-pressed', String(each === button));
            }
            onChange(axis);
        });
        return button;
    });
    return element(
        'div',
        { class: 'segmented up-control', role: 'group', 'aria-label': say('Axis that points up') },
        buttons,
    );
}
