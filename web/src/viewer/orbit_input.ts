import { kFirstOrbit, type Orbit, turned, zoomed } from './orbit';

/** Holds an orbit for one pane, or for several that are to turn together. */
export class OrbitSource {
    private orbit_: Orbit;
    private readonly listeners_ = new Set<() => void>();

    constructor(orbit: Orbit = kFirstOrbit) {
        this.orbit_ = { ...orbit };
    }

    get orbit(): Orbit {
        return this.orbit_;
    }

    set(orbit: Orbit): void {
        this.orbit_ = orbit;
        for (const listener of this.listeners_) {
            listener();
        }
    }

    /** Returns what ends the subscription. */
    subscribe(listener: () => void): () => void {
        this.listeners_.add(listener);
        return () => this.listeners_.delete(listener);
    }
}

const kRadiansPerPixel = 0.009;
const kRadiansPerKey = 0.12;
const kZoomPerKey = 1.12;
const kZoomPerWheelPixel = 0.0012;

function onKey(source: OrbitSource, event: KeyboardEvent): void {
    const moves: Record<string, () => Orbit> = {
        ArrowLeft: () => turned(source.orbit, -kRadiansPerKey, 0),
        ArrowRight: () => turned(source.orbit, kRadiansPerKey, 0),
        ArrowUp: () => turned(source.orbit, 0, kRadiansPerKey),
        ArrowDown: () => turned(source.orbit, 0, -kRadiansPerKey),
        '+': () => zoomed(source.orbit, 1 / kZoomPerKey),
        '=': () => zoomed(source.orbit, 1 / kZoomPerKey),
        '-': () => zoomed(source.orbit, kZoomPerKey),
        Home: () => ({ ...kFirstOrbit }),
    };
    const move = moves[event.key];
    if (move && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        source.set(move());
    }
}

/**
 * Drag turns, wheel (with Ctrl or the focus where the page scrolls) and pinch zoom, arrow keys turn, + and - zoom, Home resets. `source` is asked at
 * each event, so that a pane can change from its own orbit to a shared one. Returns what undoes it.
 */
export function attachOrbitInput(target: HTMLElement, source: () => OrbitSource): () => void {
    const pointers = new Map<number, { x: number; y: number }>();
    const spread = (): number => {
        const [first, second] = [...pointers.values()];
        return first && second ? Math.hypot(first.x - second.x, first.y - second.y) : 0;
    };
    const down = (event: PointerEvent): void => {
        target.setPointerCapture(event.pointerId);
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    };
    const move = (event: PointerEvent): void => {
        const last = pointers.get(event.pointerId);
        if (!last) {
            return;
        }
        const before = spread();
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        if (pointers.size === 2) {
            const after = spread();
            source().set(zoomed(source().orbit, after > 0 && before > 0 ? before / after : 1));
        } else if (pointers.size === 1) {
            const right = event.clientX - last.x;
            const below = event.clientY - last.y;
            source().set(
                turned(source().orbit, -right * kRadiansPerPixel, below * kRadiansPerPixel),
            );
        }
    };
    const up = (event: PointerEvent): void => {
        pointers.delete(event.pointerId);
    };
    const wheel = (event: WheelEvent): void => {
        // On a page that scrolls the wheel is the page's, until one has taken to the picture.
        const taken = event.ctrlKey || document.activeElement === target;
        if (!taken && target.closest('dialog') === null) {
            return;
        }
        event.preventDefault();
        const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
        const factor = Math.exp(event.deltaY * pixels * kZoomPerWheelPixel);
        source().set(zoomed(source().orbit, factor));
    };
    const key = (event: KeyboardEvent): void => onKey(source(), event);

    const undo = new AbortController();
    const { signal } = undo;
    target.addEventListener('pointerdown', down, { signal });
    target.addEventListener('pointermove', move, { signal });
    target.addEventListener('pointerup', up, { signal });
    target.addEventListener('pointercancel', up, { signal });
    target.addEventListener('wheel', wheel, { signal, passive: false });
    target.addEventListener('keydown', key, { signal });
    return () => undo.abort();
}
