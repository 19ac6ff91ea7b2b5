import {
    BufferAttribute,
    BufferGeometry,
    Color,
    DoubleSide,
    Mesh,
    MeshStandardMaterial,
    Quaternion,
    Vector3,
} from 'three';

import type { UpAxis } from '../api/elements';
import type { Match } from '../api/types';
import { element } from '../page/element';
import { say } from '../words/say';
import { alignment } from './alignment';
import { oklch } from './branch_colors';
import { disposeBelow } from './dispose';
import { ModelScene } from './model_scene';
import type { OrbitSource } from './orbit_input';
import { Picture } from './picture';
import type { View, ViewedModel } from './query_view';
import { inSlices } from './slices';
import { SurfaceDistance } from './surface_distance';
import { onThemeChange, readViewerTheme } from './theme';
import { toggle } from './toggle';
import { Stand } from './up_axis';

export interface OverlayInput {
    query: ViewedModel;
    hit: ViewedModel;
    match: Match;
    orbit: OrbitSource;
}

/** Shares of the query's radius from which on a distance has the last colour. */
export const kFarShare = 0.15;
const kShades = 6;
const kFineShades = 128;

/** From near, blue and dark, to far, yellow and light: told apart without hues, too. */
export function distanceColor(share: number): string {
    const at = Math.min(1, Math.max(0, share / kFarShare));
    return oklch(0.42 + 0.45 * at, 0.13, 255 - 165 * at);
}

/** The hit's surface where it lies on the query, and how far from it at each vertex. */
export interface Overlaid {
    /** Three numbers a corner, three corners a triangle, in the query's unit sphere. */
    corners: Float32Array;
    /** One a corner, in radii of the query. */
    distances: Float32Array;
    mean: number;
    most: number;
}

/** Corners between two looks at the clock. */
const kStep = 60;

/** A step at a time: it takes some tenths of a second. */
export function* layingOver(
    query: ModelScene,
    hit: ModelScene,
    match: Match,
    upright: readonly Quaternion[] = [],
): Generator<void, Overlaid> {
    const pairs = match.nodes.flatMap(({ a, b }) => {
        const [to, from] = [query.nodePosition(a), hit.nodePosition(b)];
        return to && from ? [{ from, to }] : [];
    });
    const first = query.corners;
    const corners = hit.corners;
    const matched = { from: pairs.map(({ from }) => from), to: pairs.map(({ to }) => to) };
    const { matrix } = yield* alignment(first, corners, matched, upright);
    const target = new SurfaceDistance(first);
    const distances = new Float32Array(corners.length / 3);
    // Corners of neighbouring triangles lie at the same place.
    const known = new Map<string, number>();
    const point = new Vector3();
    for (let at = 0; at < distances.length; at++) {
        if (at % kStep === 0) {
            yield;
        }
        point
            .fromArray(corners, 3 * at)
            .applyMatrix4(matrix)
            .toArray(corners, 3 * at);
        const place = `${corners[3 * at]} ${corners[3 * at + 1]} ${corners[3 * at + 2]}`;
        const distance = known.get(place) ?? target.to(point);
        known.set(place, distance);
        distances[at] = distance;
    }
    const values = [...known.values()];
    return {
        corners,
        distances,
        mean: values.reduce((sum, each) => sum + each, 0) / Math.max(1, values.length),
        most: Math.max(0, ...values),
    };
}

/** The quarter turns about the vertical that stand the hit upright where the query is. */
export function uprightTurns(query: UpAxis, hit: UpAxis): Quaternion[] {
    const standing = (up: UpAxis): Quaternion => {
        const stand = new Stand();
        stand.upAxis = up;
        return stand.quaternion;
    };
    const vertical = new Vector3(0, 1, 0);
    return [0, 1, 2, 3].map((quarter) =>
        standing(query)
            .clone()
            .invert()
            .multiply(new Quaternion().setFromAxisAngle(vertical, (quarter * Math.PI) / 2))
            .multiply(standing(hit)),
    );
}

function coloredMesh({ corners, distances }: Overlaid): Mesh {
    const geometry = new BufferGeometry();
    const colors = new Float32Array(corners.length);
    // Each shade is made once, and there are more than eyes can tell apart.
    const shades = Array.from({ length: kFineShades + 1 }, (_, at) =>
        new Color(distanceColor((kFarShare * at) / kFineShades)).toArray(),
    );
    for (const [at, distance] of distances.entries()) {
        const shade = Math.min(kFineShades, Math.round((kFineShades * distance) / kFarShare));
        colors.set(shades[shade] ?? [], 3 * at);
    }
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.setAttribute('color', new BufferAttribute(colors, 3));
    geometry.computeVertexNormals();
    const material = new MeshStandardMaterial({
        vertexColors: true,
        roughness: 0.8,
        side: DoubleSide,
    });
    return new Mesh(geometry, material);
}

function percent(share: number): string {
    return `${(100 * share).toFixed(1)} %`;
}

function legend({ mean, most }: Overlaid): HTMLElement {
    const shades = Array.from({ length: kShades }, (_, at) => (kFarShare * at) / (kShades - 1));
    return element(
        'div',
        { class: 'overlay-legend' },
        element('span', {}, '0'),
        element(
            'span',
            { class: 'overlay-shades', 'aria-hidden': 'true' },
            shades.map((share) => element('span', { '--color': distanceColor(share) })),
        ),
        element('span', {}, `≥ ${percent(kFarShare)}`),
        element(
            'p',
            {},
            say(
                'Distance of the surfaces in shares of the query’s radius: {mean} on average, {most} at most.',
                {
                    mean: percent(mean),
                    most: percent(most),
                },
            ),
        ),
    );
}

const kEmpty = { unit: 'model', nodes: [], branches: [] } as const;

/** Lays the hit over the query. */
function* layingHitOver({ query, hit, match }: OverlayInput): Generator<void, Overlaid> {
    const theme = readViewerTheme();
    const scenes: ModelScene[] = [];
    try {
        for (const model of [query, hit]) {
            scenes.push(new ModelScene({ ...model, branchColors: new Map() }, theme));
            yield;
        }
        const [first, second] = scenes as [ModelScene, ModelScene];
        return yield* layingOver(first, second, match, uprightTurns(query.up, hit.up));
    } finally {
        for (const scene of scenes) {
            scene.dispose();
        }
    }
}

/** The hit laid over the query, coloured by how far it is from it. */
function overlay({ query, hit, orbit }: OverlayInput, overlaid: Overlaid): View {
    const picture = new Picture({
        label: say('{hit} laid over {query}', { hit: hit.name, query: query.name }),
        orbit,
        up: query.up,
        beforeDraw: () => {},
    });
    const theme = readViewerTheme();
    const ghost = new ModelScene(
        {
            mesh: query.mesh,
            skeleton: { ...kEmpty, nodes: [], branches: [] },
            branchColors: new Map(),
        },
        theme,
    );
    const colored = coloredMesh(overlaid);
    picture.stand.add(ghost.root, colored);
    const switches = element(
        'div',
        { class: 'overlay-switches' },
        toggle(say('Query'), true, (on) => {
            ghost.root.visible = on;
            picture.requestDraw();
        }),
        toggle(say('Hit'), true, (on) => {
            colored.visible = on;
            picture.requestDraw();
        }),
    );
    const unsubscribe = onThemeChange(() => {
        ghost.applyTheme(readViewerTheme());
        picture.requestDraw();
    });
    return {
        node: element('div', { class: 'overlay' }, picture.node, switches, legend(overlaid)),
        dispose() {
            unsubscribe();
            ghost.dispose();
            disposeBelow(picture.stand);
            picture.dispose();
        },
    };
}

/** After the browser has shown that something is under way. */
function nextFrame(): Promise<void> {
    return new Promise((resolve) => {
        requestAnimationFrame(() => setTimeout(resolve, 0));
    });
}

/** A switch between two pictures beside each other and one over the other, which is made when asked for. */
export class OverlaySwitch {
    readonly control: HTMLElement;
    private readonly input_: OverlayInput;
    private readonly sides_: HTMLElement;
    private view_: View | null = null;
    private waiting_: HTMLElement | null = null;
    private disposed_ = false;

    /** @param sides what the overlay takes the place of */
    constructor(input: OverlayInput, sides: HTMLElement) {
        this.input_ = input;
        this.sides_ = sides;
        this.control = toggle(say('Overlay'), false, (on) => void this.show(on));
    }

    dispose(): void {
        this.disposed_ = true;
        this.view_?.dispose();
    }

    private async show(on: boolean): Promise<void> {
        const place = this.sides_.parentElement;
        if (!place) {
            return;
        }
        this.sides_.classList.toggle('sides-covered', on);
        this.waiting_?.remove();
        if (!on) {
            this.view_?.dispose();
            this.view_?.node.remove();
            this.view_ = null;
            return;
        }
        const waiting = element(
            'div',
            { class: 'overlay dialog-loading' },
            say('Laying one over the other…'),
        );
        this.sides_.after(waiting);
        // Whoever switched it off and on again has another one on the way.
        const isWanted = (): boolean => !this.disposed_ && waiting.isConnected;
        this.waiting_ = waiting;
        await nextFrame();
        const overlaid = await inSlices(layingHitOver(this.input_), isWanted);
        if (overlaid && isWanted()) {
            this.view_ = overlay(this.input_, overlaid);
            waiting.replaceWith(this.view_.node);
        }
    }
}
