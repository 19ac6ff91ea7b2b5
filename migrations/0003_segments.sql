-- The parts of the whole mesh, found when a model is indexed. Models of earlier pipelines have none,
-- nor has a model that could not be cut into parts.
CREATE TABLE segments (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    segments BLOB NOT NULL
) STRICT;
