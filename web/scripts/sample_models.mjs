// Writes a small collection of figures of our own, made of limbs with round ends.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const kSides = 20;
const kRings = 6;

const subtract = (a, b) => a.map((value, axis) => value - b[axis]);
const length = (a) => Math.hypot(...a);
const scaled = (a, by) => a.map((value) => value * by);
const added = (...all) => [0, 1, 2].map((axis) => all.reduce((sum, each) => sum + each[axis], 0));
const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];

/** A closed surface around two balls: rings from one pole to the other. */
function limb(from, to, radiusFrom, radiusTo = radiusFrom) {
    const along = subtract(to, from);
    const axis = scaled(along, 1 / Math.max(1e-9, length(along)));
    const aside = Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
    const u = scaled(cross(axis, aside), 1 / length(cross(axis, aside)));
    const v = cross(axis, u);
    const rings = [];
    for (let ring = 1; ring <= 2 * kRings; ring++) {
        const first = ring <= kRings;
        const angle = ((first ? ring : ring - 1) / (2 * kRings - 1) - 0.5) * Math.PI;
        const [center, radius] = first ? [from, radiusFrom] : [to, radiusTo];
        const middle = added(center, scaled(axis, radius * Math.sin(angle)));
        rings.push(
            Array.from({ length: kSides }, (_, side) => {
                const turn = (2 * Math.PI * side) / kSides;
                const out = radius * Math.cos(angle);
                return added(
                    middle,
                    scaled(u, out * Math.cos(turn)),
                    scaled(v, out * Math.sin(turn)),
                );
            }),
        );
    }
    const points = [
        added(from, scaled(axis, -radiusFrom)),
        ...rings.flat(),
        added(to, scaled(axis, radiusTo)),
    ];
    const at = (ring, side) => 1 + ring * kSides + (side % kSides);
    const faces = [];
    for (let side = 0; side < kSides; side++) {
        faces.push([0, at(0, side + 1), at(0, side)]);
        for (let ring = 0; ring + 1 < rings.length; ring++) {
            faces.push([
                at(ring, side),
                at(ring, side + 1),
                at(ring + 1, side + 1),
                at(ring + 1, side),
            ]);
        }
        const last = rings.length - 1;
        faces.push([points.length - 1, at(last, side), at(last, side + 1)]);
    }
    return { points, faces };
}

function off(limbs) {
    const points = [];
    const faces = [];
    for (const each of limbs) {
        const first = points.length;
        points.push(
            ...each.points.map((point) => point.map((value) => value.toFixed(5)).join(' ')),
        );
        faces.push(
            ...each.faces.map(
                (face) => `${face.length} ${face.map((vertex) => vertex + first).join(' ')}`,
            ),
        );
    }
    return `OFF\n${points.length} ${faces.length} 0\n${[...points, ...faces].join('\n')}\n`;
}

/** Four legs, a neck, a tail; `stride` moves the legs. */
function quadruped({ body, legs, neck, tail, girth, stride }) {
    const leg = (x, z, step) => {
        const hip = [x, legs, z];
        const knee = [x + step * 0.5, legs * 0.5, z * 1.05];
        const foot = [x + step, 0, z * 1.05];
        return [
            limb(hip, knee, girth * 0.5, girth * 0.3),
            limb(knee, foot, girth * 0.3, girth * 0.24),
        ];
    };
    const head = [body + neck * 0.5, legs + neck, 0];
    return [
        limb([0, legs + girth * 0.3, 0], [body, legs + girth * 0.35, 0], girth * 0.95, girth),
        ...leg(0.05, girth * 0.6, stride),
        ...leg(0.05, -girth * 0.6, -stride),
        ...leg(body, girth * 0.6, -stride),
        ...leg(body, -girth * 0.6, stride),
        limb([body, legs + girth * 0.6, 0], head, girth * 0.6, girth * 0.45),
        limb(head, added(head, [girth * 1.3, -girth * 0.4, 0]), girth * 0.5, girth * 0.3),
        limb([0, legs + girth * 0.6, 0], [-tail, legs + tail * 0.4, 0], girth * 0.22, girth * 0.12),
    ];
}

/** Two arms, two legs; angles from hanging down to straight up. */
function person({ height, girth, arms, legs }) {
    const hip = 0.5 * height;
    const shoulder = 0.8 * height;
    const arm = (side, angle) => {
        const from = [side * girth * 1.3, shoulder, 0];
        const reach = (share) => [
            from[0] + side * share * 0.42 * height * Math.sin(angle),
            from[1] - share * 0.42 * height * Math.cos(angle),
            0.02,
        ];
        return [
            limb(from, reach(0.5), girth * 0.42, girth * 0.36),
            limb(reach(0.5), reach(1), girth * 0.36, girth * 0.26),
        ];
    };
    const leg = (side, angle) => {
        const from = [side * girth * 0.65, hip, 0];
        const foot = [from[0] + side * hip * Math.sin(angle), hip - hip * Math.cos(angle), 0];
        return [
            limb(from, foot, girth * 0.6, girth * 0.32),
            limb(foot, added(foot, [0, 0, girth]), girth * 0.3, girth * 0.22),
        ];
    };
    return [
        limb([0, hip, 0], [0, shoulder, 0], girth * 0.95, girth * 1.15),
        limb([-girth, shoulder, 0], [girth, shoulder, 0], girth * 0.55),
        limb([0, shoulder, 0], [0, 0.88 * height, 0], girth * 0.4),
        limb([0, 0.92 * height, 0], [0, 0.96 * height, 0], girth * 0.75, girth * 0.7),
        ...arm(-1, arms[0]),
        ...arm(1, arms[1]),
        ...leg(-1, legs),
        ...leg(1, legs),
    ];
}

/** Five fingers, spread and bent as asked for. */
function hand({ size, spread, bend }) {
    const fingers = [-2, -1, 0, 1, 2].map((at) => {
        const long = size * (at === -2 ? 0.55 : 0.85 - 0.08 * Math.abs(at));
        const from = at === -2 ? [-size * 0.4, size * 0.35, 0] : [at * size * 0.22, size * 0.75, 0];
        const angle = at * spread + (at === -2 ? -0.6 : 0);
        const knuckle = added(from, [
            0.5 * long * Math.sin(angle),
            0.5 * long * Math.cos(angle),
            0,
        ]);
        const tip = added(knuckle, [
            0.5 * long * Math.sin(angle) * Math.cos(bend),
            0.5 * long * Math.cos(angle) * Math.cos(bend),
            0.5 * long * Math.sin(bend),
        ]);
        return [limb(from, knuckle, size * 0.1), limb(knuckle, tip, size * 0.1, size * 0.075)];
    });
    return [
        limb([-size * 0.2, size * 0.35, 0], [-size * 0.2, size * 0.7, 0], size * 0.24),
        limb([size * 0.2, size * 0.35, 0], [size * 0.2, size * 0.7, 0], size * 0.24),
        limb([0, -size * 0.3, 0], [0, size * 0.4, 0], size * 0.2, size * 0.26),
        ...fingers.flat(),
    ];
}

/** A beam with a fuselage: two wings, a fin, two tail wings. */
function plane({ long, wings, sweep }) {
    const r = 0.09 * long;
    const wing = (side, x, span) =>
        limb(
            [x, 0, side * r * 0.6],
            [x - sweep * span, 0.04 * long, side * span],
            r * 0.5,
            r * 0.2,
        );
    return [
        limb([0, 0, 0], [long, 0, 0], r * 0.55, r),
        ...[-1, 1].flatMap((side) => [
            wing(side, 0.62 * long, wings),
            wing(side, 0.1 * long, 0.35 * wings),
        ]),
        limb([0.1 * long, 0, 0], [0, 0.28 * long, 0], r * 0.45, r * 0.25),
    ];
}

/** Four legs and a seat, with a back or without. */
function seat({ wide, high, back, thick }) {
    const corners = [-1, 1].flatMap((x) => [-1, 1].map((z) => [x * wide, z * wide]));
    const slats = [-0.75, -0.25, 0.25, 0.75].map((z) =>
        limb([-wide, high, z * wide], [wide, high, z * wide], thick * 1.6),
    );
    return [
        ...slats,
        ...corners.map(([x, z]) => limb([x, 0, z], [x, high, z], thick)),
        ...(back > 0
            ? [-1, 1]
                  .map((z) =>
                      limb([-wide, high, z * wide], [-wide * 1.2, high + back, z * wide], thick),
                  )
                  .concat(
                      [0.55, 0.95].map((share) =>
                          limb(
                              [-wide * (1 + 0.2 * share), high + back * share, -wide],
                              [-wide * (1 + 0.2 * share), high + back * share, wide],
                              thick,
                          ),
                      ),
                  )
            : []),
    ];
}

const kSteps = [0, 1, 2, 3, 4];
const kFigures = {
    'animals/dog': kSteps.map((n) =>
        quadruped({
            body: 1.2 + 0.06 * n,
            legs: 0.75,
            neck: 0.45,
            tail: 0.5,
            girth: 0.24,
            stride: 0.12 * n,
        }),
    ),
    'animals/horse': kSteps.map((n) =>
        quadruped({
            body: 1.7,
            legs: 1.35 + 0.04 * n,
            neck: 0.85,
            tail: 0.6,
            girth: 0.34,
            stride: 0.16 * n,
        }),
    ),
    'animals/giraffe': kSteps.map((n) =>
        quadruped({
            body: 1.3,
            legs: 1.6,
            neck: 1.7 + 0.08 * n,
            tail: 0.4,
            girth: 0.3,
            stride: 0.1 * n,
        }),
    ),
    people: kSteps.map((n) =>
        person({
            height: 1.8 + 0.04 * n,
            girth: 0.16,
            arms: [0.35 + 0.5 * n, 0.35 + 0.3 * n],
            legs: 0.1 + 0.08 * n,
        }),
    ),
    hands: kSteps.map((n) => hand({ size: 1 + 0.05 * n, spread: 0.1 + 0.05 * n, bend: 0.22 * n })),
    planes: kSteps.map((n) => plane({ long: 2.2, wings: 1.1 + 0.1 * n, sweep: 0.15 + 0.12 * n })),
    'furniture/chair': kSteps.map((n) =>
        seat({ wide: 0.45, high: 0.85 + 0.05 * n, back: 0.8 + 0.05 * n, thick: 0.06 }),
    ),
    'furniture/stool': kSteps.map((n) =>
        seat({ wide: 0.42, high: 0.7 + 0.12 * n, back: 0, thick: 0.07 }),
    ),
};

/** Writes the figures below `folder` and their classes into `classes`. */
export function writeSampleModels(folder, classes) {
    const lines = ['PSB 1', '', ''];
    let models = 0;
    for (const [place, figures] of Object.entries(kFigures)) {
        const name = place.slice(place.lastIndexOf('/') + 1);
        const parent = place.includes('/') ? place.slice(0, place.indexOf('/')) : place;
        mkdirSync(join(folder, parent), { recursive: true });
        lines.push(`${name} 0 ${figures.length}`);
        for (const [at, figure] of figures.entries()) {
            const id = `${name}-${at + 1}`;
            writeFileSync(join(folder, parent, `${id}.off`), off(figure));
            lines.push(id);
            models += 1;
        }
        lines.push('');
    }
    lines[1] = `${Object.keys(kFigures).length} ${models}`;
    writeFileSync(classes, lines.join('\n'));
    return models;
}
