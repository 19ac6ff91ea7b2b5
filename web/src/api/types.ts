/**
 * The JSON that the server speaks, field by field as it is sent. Units are those of the model's file
 * unless a name says otherwise.
 */

export type Point = [number, number, number];

/** The axis of a model's file that points up. */
export type UpAxis = 'y' | 'z';

/** That of models of which nobody says it. */
export const kUsualUp: UpAxis = 'y';

export interface Bounds {
    min: Point;
    max: Point;
}

export interface Warning {
    code: string;
    count: number;
    message: string;
}

export interface ModelSummary {
    id: number;
    name: string;
    class: string | null;
    path: string;
    content_hash: string;
    vertices: number;
    faces: number;
    nodes: number;
    branches: number;
    bounds: Bounds;
    surface_area: number;
    indexed_at: string;
    warnings: Warning[];
    up?: UpAxis;
}

export interface ModelPage {
    models: ModelSummary[];
    next_cursor: string | null;
    total: number;
    revision: number;
}

export interface SkeletonNode {
    id: number;
    position: Point;
    radius: number;
    degree: number;
    significance: number;
}

export interface SkeletonBranch {
    id: number;
    a: number;
    b: number;
    length: number;
    points: Point[];
    radii: number[];
    chain_code: string;
}

export interface Skeleton {
    unit: string;
    nodes: SkeletonNode[];
    branches: SkeletonBranch[];
}

/** At most a few thousand triangles: what the index keeps for drawing. */
export interface PreviewMesh {
    /** From where the positions are counted, in the file's frame; missing: from the file's own origin. */
    origin?: Point;
    positions: number[];
    triangles: number[];
    bounds: Bounds;
}

export interface SegmentPart {
    part: number;
    /** `#rrggbb`. */
    colour: string;
    triangles: number;
    area: number;
    /** Of the whole surface, 0 to 1. */
    area_share: number;
    /** Of the model's skeleton; null without one. */
    branch: number | null;
    neighbors: number[];
}

/** The parts that people would see, by descending area. */
export interface Segments {
    parts: SegmentPart[];
    /** The part of each triangle of the preview mesh. */
    labels: number[];
}

export interface MatchedPair {
    /** Id on the query's side. */
    a: number;
    /** Id on the hit's side. */
    b: number;
    cost: number;
}

export interface Correspondence {
    nodes: MatchedPair[];
    branches: MatchedPair[];
    cluster_sizes: number[];
}

export interface Hit {
    rank: number;
    id: number;
    name: string;
    class: string | null;
    distance: number;
    parts: Record<string, number>;
    matched_nodes: number;
    match: Correspondence;
}

export type Ranker = 'hybrid' | 'skeleton' | 'chain-code';

export const kRankers: readonly Ranker[] = ['hybrid', 'skeleton', 'chain-code'];

export interface QueryModel {
    name: string;
    vertices: number;
    faces: number;
    warnings: Warning[];
    skeleton: Skeleton;
    mesh?: PreviewMesh;
    up?: UpAxis;
}

export interface SearchResult {
    took_ms: number;
    stages_ms: Record<string, number>;
    ranker: Ranker;
    pose: number;
    rerank: boolean;
    models: number;
    query: QueryModel;
    hits: Hit[];
}

export interface RetrievalMetrics {
    nearest_neighbor: number;
    first_tier: number;
    second_tier: number;
    e_measure: number;
    dcg: number;
    mean_average_precision: number;
}

export interface PrecisionRecallPoint {
    recall: number;
    precision: number;
}

export interface ClassMetrics extends RetrievalMetrics {
    models: number;
}

export interface Confusion {
    classes: string[];
    /** Row: class of the query; column: class of its nearest neighbour; a share of 0 to 1. */
    values: number[][];
}

export interface Evaluation extends RetrievalMetrics {
    models: number;
    classes: number;
    ranker: Ranker;
    rerank: boolean;
    precision_recall: PrecisionRecallPoint[];
    per_class: Record<string, ClassMetrics>;
    confusion: Confusion;
}

/** RFC 9457 problem document with the project's stable `code`. */
export interface Problem {
    title: string;
    status: number;
    detail: string;
    code: string;
    instance?: string;
    request_id?: string;
}
