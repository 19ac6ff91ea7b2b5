import { vi } from 'vitest';

import type { Client } from '../src/api/client';
import type { ModelSummary, PreviewMesh } from '../src/api/elements';
import { kSearchDefaults } from '../src/api/search_parameters';
import type { Evaluation, Facets, Hit, SearchResult, Skeleton, Vector } from '../src/api/types';
import type { Context } from '../src/page/context';
import { KnownFacets } from '../src/page/known_facets';
import { Recent } from '../src/page/recent';
import { Selection } from '../src/page/selection';
import { Uploads } from '../src/page/uploads';

/** Small answers in the server's shapes, for tests that are not about their contents. */

export function skeleton(lines: readonly Vector[][]): Skeleton {
    const nodes = lines.flatMap((line, index) =>
        [line[0], line.at(-1)].map((position, end) => ({
            id: 2 * index + end,
            position: position ?? ([0, 0, 0] as Vector),
            radius: 0.1,
            degree: 1,
            significance: 1,
        })),
    );
    const branches = lines.map((points, id) => ({
        id,
        a: 2 * id,
        b: 2 * id + 1,
        length: points.length - 1,
        points,
        radii: points.map(() => 0.1),
        chain_code: '0'.repeat(Math.max(0, points.length - 1)),
    }));
    return { unit: 'model', nodes, branches };
}

export const kSkeleton = skeleton([
    [
        [0, 0, 0],
        [1, 0, 0],
        [2, 0, 0],
        [3, 0, 0],
    ],
    [
        [0, 0, 0],
        [0, 1, 0],
    ],
]);

export const kMesh: PreviewMesh = {
    origin: [0, 0, 0],
    positions: [0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 1],
    triangles: [0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3],
    colours: null,
    bounds: { min: [0, 0, 0], max: [3, 1, 1] },
};

export function model(id: number, fields: Partial<ModelSummary> = {}): ModelSummary {
    return {
        id,
        name: `model${id}`,
        class: 'chair',
        path: `models/model${id}.off`,
        content_hash: '0'.repeat(32),
        vertices: 10,
        faces: 20,
        nodes: 4,
        branches: 2,
        bounds: kMesh.bounds,
        surface_area: 1,
        unit: null,
        metres_per_unit: null,
        up_from: 'shape',
        indexed_at: '2026-01-01T00:00:00Z',
        up: 'y',
        warnings: [],
        links: {
            mesh: `/v1/models/${id}/mesh`,
            skeleton: `/v1/models/${id}/skeleton`,
            similar: `/v1/models/${id}/similar`,
            segments: `/v1/models/${id}/segments`,
            rig: `/v1/models/${id}/rig.glb`,
            thumbnail: `/v1/models/${id}/thumbnail.png?v=1`,
        },
        ...fields,
    };
}

export function hit(rank: number, fields: Partial<Hit> = {}): Hit {
    return {
        rank,
        placement: null,
        id: 100 + rank,
        name: `hit${rank}`,
        class: 'chair',
        path: `chairs/hit${rank}.off`,
        faces: 20,
        extent: [3, 1, 1],
        copies: 0,
        thumbnail: `/v1/models/${100 + rank}/thumbnail.png?v=1`,
        distance: rank / 10,
        parts: { skeleton: rank / 20, moments: rank / 20 },
        build_difference: 0.4,
        pose_difference: 0.8,
        matched_nodes: 2,
        match: {
            nodes: [{ a: 0, b: 0, cost: 0.1 }],
            branches: [{ a: 0, b: 1, cost: 0.1 }],
            cluster_sizes: [2],
        },
        ...fields,
    };
}

export function searchResult(hits: Hit[] = [hit(1), hit(2)]): SearchResult {
    return {
        took_ms: 84,
        stages_ms: { read: 2, thin: 80, rank: 2 },
        ranker: 'hybrid',
        pose: 0.15,
        size: 0,
        rerank: false,
        part: false,
        models: 380,
        query: {
            name: 'elephant',
            vertices: 10,
            faces: 20,
            unit: null,
            metres_per_unit: null,
            warnings: [],
            skeleton: kSkeleton,
            mesh: kMesh,
        },
        hits,
    };
}

const kFigures = {
    nearest_neighbor: 0.9,
    first_tier: 0.6,
    second_tier: 0.8,
    e_measure: 0.5,
    dcg: 0.85,
    mean_average_precision: 0.7,
};

export function evaluation(fields: Partial<Evaluation> = {}): Evaluation {
    return {
        ...kFigures,
        models: 40,
        classes: 2,
        queries_total: 4,
        intervals: {
            nearest_neighbor: { low: 0.4, high: 0.6 },
            first_tier: { low: 0.4, high: 0.6 },
            second_tier: { low: 0.4, high: 0.6 },
            e_measure: { low: 0.4, high: 0.6 },
            dcg: { low: 0.4, high: 0.6 },
            mean_average_precision: { low: 0.4, high: 0.6 },
        },
        ranker: 'hybrid',
        rerank: false,
        precision_recall: [
            { recall: 0.5, precision: 0.9 },
            { recall: 1, precision: 0.4 },
        ],
        per_class: {
            table: { models: 20, ...kFigures },
            ant: { models: 20, ...kFigures, nearest_neighbor: 1 },
        },
        confusion: {
            classes: ['ant', 'table'],
            values: [
                [1, 0],
                [0.2, 0.8],
            ],
        },
        ...fields,
    };
}

export const kNoFacets: Facets = {
    classes: [],
    folders: [],
    kinds: [],
    branches: [],
    loops: [],
    extents: [],
    units: [],
    revision: 1,
};

/** A server that was not expected to be asked. */
function refuse(): Promise<never> {
    return Promise.reject(new Error('not expected to be asked'));
}

export function clientWith(methods: Partial<Client>): Client {
    return {
        search: refuse,
        similar: refuse,
        compare: refuse,
        models: refuse,
        facets: async () => kNoFacets,
        progress: async () => ({ stage: null }),
        model: refuse,
        mesh: refuse,
        skeleton: refuse,
        segments: refuse,
        rig: refuse,
        evaluation: refuse,
        evaluatedQueries: refuse,
        ...methods,
    };
}

export interface RecordedContext extends Context {
    visited: unknown[];
    announced: string[];
    titles: string[];
}

export function contextWith(methods: Partial<Client>): RecordedContext {
    const visited: unknown[] = [];
    const announced: string[] = [];
    const titles: string[] = [];
    const client = clientWith(methods);
    return {
        client,
        facets: new KnownFacets(client),
        uploads: new Uploads(client),
        selection: new Selection(),
        answers: new Recent(3, 60_000),
        parameters: kSearchDefaults,
        navigate: (route) => void visited.push(route),
        replace: (route) => void visited.push(route),
        back: (route) => void visited.push(route),
        entitle: (title) => void titles.push(title),
        rewrite: (route) => void visited.push(route),
        announce: (message) => void announced.push(message),
        visited,
        announced,
        titles,
    };
}

/** Lets promises that are settled already do their work. */
export async function settled(): Promise<void> {
    for (let turn = 0; turn < 20; turn++) {
        await Promise.resolve();
    }
    await new Promise((resolve) => setTimeout(resolve, 0));
}

/** Until a check holds; on a busy machine a module alone may take seconds to arrive. */
export function eventually(check: () => void): Promise<void> {
    return vi.waitFor(check, { timeout: 120_000 });
}

/** Numbers that look random and are the same at each run. */
export function randomNumbers(seed: number): () => number {
    let state = seed;
    return () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32;
    };
}
