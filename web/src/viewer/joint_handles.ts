import { element } from '../page/element';
import type { ScreenPoint } from './pick';
import type { Handle } from './pose';
import { say } from '../words/say';

export interface JointHandlesOptions {
    handles: readonly Handle[];
    /** Where a handle is seen; `depth` from -1 (near) to 1. */
    locate: (handle: Handle) => ScreenPoint & { depth: number };
    pointOf: (event: PointerEvent) => ScreenPoint;
    onDrag: (handle: Handle, to: ScreenPoint) => void;
    /** By steps to the right and upwards. */
    onStep: (handle: Handle, right: number, up: number) => void;
    onReset: (handle: Handle) => void;
    /** A drag or a press of a key is over. */
    onDone: () => void;
}

const kSteps: Readonly<Record<string, readonly [right: number, up: number]>> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
};

/**
 * The joints as buttons over the picture: something to drag, to reach with Tab and to move with the
 * arrow keys; Home puts a joint back.
 */
export class JointHandles {
    readonly node = element('div', {
        class: 'joint-handles',
        role: 'group',
        'aria-label': say('Joints'),
    });
    private readonly options_: JointHandlesOptions;
    private readonly buttons_ = new Map<Handle, HTMLButtonElement>();

    constructor(options: JointHandlesOptions) {
        this.options_ = options;
        for (const handle of options.handles) {
            const button = element('button', {
                type: 'button',
                class: 'joint-handle',
                'aria-label': say('Joint {number}: drag it, or move it with the arrow keys', {
                    number: handle.number,
                }),
            });
            this.listen(handle, button);
            this.buttons_.set(handle, button);
            this.node.append(button);
        }
    }

    set visible(on: boolean) {
        this.node.hidden = !on;
    }

    /** Lays the buttons over their joints, the nearer ones on top. */
    place(): void {
        for (const [handle, button] of this.buttons_) {
            const { x, y, depth } = this.options_.locate(handle);
            button.style.setProperty('--x', `${x.toFixed(2)}px`);
            button.style.setProperty('--y', `${y.toFixed(2)}px`);
            button.style.setProperty('--layer', String(Math.round(1000 * (1 - depth))));
        }
    }

    private listen(handle: Handle, button: HTMLButtonElement): void {
        const { locate, pointOf, onDrag, onStep, onReset, onDone } = this.options_;
        // From the pointer to the middle of the handle, so that it does not jump when it is taken.
        let grip: ScreenPoint | null = null;
        button.addEventListener('pointerdown', (event) => {
            if (event.button !== 0) {
                return;
            }
            button.setPointerCapture(event.pointerId);
            const at = pointOf(event);
            const seen = locate(handle);
            grip = { x: seen.x - at.x, y: seen.y - at.y };
        });
        button.addEventListener('pointermove', (event) => {
            if (grip) {
                const at = pointOf(event);
                onDrag(handle, { x: at.x + grip.x, y: at.y + grip.y });
            }
        });
        for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
            button.addEventListener(end, () => {
                if (grip) {
                    grip = null;
                    onDone();
                }
            });
        }
        button.addEventListener('keydown', (event) => {
            const step = kSteps[event.key];
            if (event.ctrlKey || event.metaKey || event.altKey || (!step && event.key !== 'Home')) {
                return;
            }
            event.preventDefault();
            if (step) {
                onStep(handle, ...step);
            } else {
                onReset(handle);
            }
            onDone();
        });
    }
}
