import { afterAll, afterEach, beforeAll, beforeEach, expect, it, vi } from 'vitest';

import { OrbitSource } from '../../src/viewer/orbit_input';
import type { Picture } from '../../src/viewer/picture';
import { eventually } from '../sample';

const render = vi.fn();
let PictureWithoutWebGl: typeof Picture;

// There is no WebGL here. The tests share their modules: this one has to have its own.
beforeAll(async () => {
    vi.resetModules();
    vi.doMock('three', async (original) => ({
        ...(await original<typeof import('three')>()),
        WebGLRenderer: class {
            render = render;
            setPixelRatio(): void {}
            setSize(): void {}
            dispose(): void {}
            forceContextLoss(): void {}
        },
    }));
    ({ Picture: PictureWithoutWebGl } = await import('../../src/viewer/picture'));
});

afterAll(() => {
    vi.doUnmock('three');
    vi.resetModules();
});

let resize: () => void = () => {};
let picture: Picture | null = null;

beforeEach(() => {
    render.mockClear();
    vi.stubGlobal(
        'ResizeObserver',
        class {
            constructor(callback: () => void) {
                resize = callback;
            }
            observe(): void {}
            disconnect(): void {}
        },
    );
});

afterEach(() => {
    picture?.dispose();
    picture = null;
    vi.unstubAllGlobals();
});

function placed(orbit = new OrbitSource()): Picture {
    const made = new PictureWithoutWebGl({ label: 'a pig', orbit, up: 'y', beforeDraw: () => {} });
    picture = made;
    return made;
}

function give(size: number): void {
    for (const name of ['clientWidth', 'clientHeight']) {
        Object.defineProperty(picture?.node, name, { value: size, configurable: true });
    }
    resize();
}

const stateOf = (shown: Picture) => shown.canvas.dataset.picture;

it('is pending until it has a place, and drawn at once then', async () => {
    const shown = placed();
    expect(stateOf(shown)).toBe('pending');
    await new Promise(requestAnimationFrame);
    expect(render).not.toHaveBeenCalled();
    expect(stateOf(shown)).toBe('pending');
    give(0);
    expect(stateOf(shown)).toBe('pending');
    give(200);
    expect(render).toHaveBeenCalledOnce();
    expect(stateOf(shown)).toBe('drawn');
});

it('is pending from a wish to the next frame, whoever has it', async () => {
    const orbit = new OrbitSource();
    const shown = placed(orbit);
    give(200);
    const wishes = [
        () => shown.requestDraw(),
        () => orbit.set({ ...orbit.orbit, azimuth: 1 }),
        () => shown.follow(new OrbitSource()),
        () => shown.node.querySelector<HTMLButtonElement>('.up-control [value=z]')?.click(),
    ];
    for (const wish of wishes) {
        render.mockClear();
        wish();
        expect(stateOf(shown)).toBe('pending');
        await eventually(() => expect(stateOf(shown)).toBe('drawn'));
        expect(render).toHaveBeenCalledOnce();
    }
});
