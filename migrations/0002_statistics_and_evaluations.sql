-- What is computed over the whole collection and kept because it takes long.

-- One row: what the rankers' normalisation needs, and the revision that it was made at.
CREATE TABLE statistics (
    id INTEGER NOT NULL PRIMARY KEY CHECK (id = 1),
    revision INTEGER NOT NULL,
    statistics BLOB NOT NULL
) STRICT;

-- Retrieval reports, valid for one revision and one set of evaluated models.
CREATE TABLE evaluations (
    revision INTEGER NOT NULL,
    ranker TEXT NOT NULL,
    rerank INTEGER NOT NULL CHECK (rerank IN (0, 1)),
    pose REAL NOT NULL,
    collection_hash TEXT NOT NULL,             -- of the models and their classes
    computed_at TEXT NOT NULL,                 -- ISO 8601, UTC
    report BLOB NOT NULL,
    PRIMARY KEY (revision, ranker, rerank, pose, collection_hash)
) STRICT, WITHOUT ROWID;
