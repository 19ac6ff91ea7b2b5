import type {
    Evaluation,
    Mesh,
    Metrics,
    Model,
    Ranker,
    SearchResult,
    Segments,
    Skeleton,
} from './types';

/**
 * What the server's answers are made of and its description gives no name of its own. Units are those
 * of the model's file unless a name says otherwise.
 */

export type SkeletonNode = Skeleton['nodes'][number];
export type SkeletonBranch = Skeleton['branches'][number];
export type SegmentPart = Segments['parts'][number];
export type ClassMetrics = Metrics & { models: number };
export type Confusion = Evaluation['confusion'];

/** The axis of a model's file that points up. */
export type UpAxis = Model['up'];

/** That of models of which nobody says it. */
export const kUsualUp: UpAxis = 'y';

export type ModelSummary = Model;
export type QueryModel = SearchResult['query'];

/** At most a few thousand triangles: what the index keeps for drawing. */
export type PreviewMesh = Mesh;
export type MeshColours = NonNullable<Mesh['colours']>;

const kRankerOrder: Readonly<Record<Ranker, number>> = { hybrid: 0, skeleton: 1, 'chain-code': 2 };

/** All of them, in the order in which they are offered. */
export const kRankers = (Object.keys(kRankerOrder) as Ranker[]).sort(
    (a, b) => kRankerOrder[a] - kRankerOrder[b],
);
