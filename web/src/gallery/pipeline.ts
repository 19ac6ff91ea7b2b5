/** The stages of a search, as a model goes through them. */
export const kPipeline: readonly string[] = [
    'read',
    'voxelize',
    'distance_transform',
    'thin',
    'refine',
    'surface',
    'describe_skeleton',
    'turned_skeletons',
    'global_descriptors',
    'signature',
    'rank',
    'explain',
];
