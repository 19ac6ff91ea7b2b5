-- Models with all that was derived from them, failures, and the numbers that readers follow.
-- Blobs are specified in docs/index-format.md.

-- What the index was built with; fixed when it is made.
CREATE TABLE parameters (
    name TEXT NOT NULL PRIMARY KEY,
    value TEXT NOT NULL
) STRICT, WITHOUT ROWID;

-- One row. `revision` counts the committed changes of models.
CREATE TABLE state (
    id INTEGER NOT NULL PRIMARY KEY CHECK (id = 1),
    revision INTEGER NOT NULL CHECK (revision >= 0)
) STRICT;
INSERT INTO state (id, revision) VALUES (1, 0);

CREATE TABLE models (
    id INTEGER NOT NULL PRIMARY KEY AUTOINCREMENT,
    path TEXT UNIQUE CHECK (path <> ''),       -- absolute; NULL for an uploaded model
    name TEXT NOT NULL,
    class TEXT NOT NULL DEFAULT '',            -- '' = none known
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 32),
    vertices INTEGER NOT NULL CHECK (vertices >= 0),
    faces INTEGER NOT NULL CHECK (faces >= 0),
    nodes INTEGER NOT NULL CHECK (nodes >= 0),
    branches INTEGER NOT NULL CHECK (branches >= 0),
    min_x REAL NOT NULL, min_y REAL NOT NULL, min_z REAL NOT NULL,
    max_x REAL NOT NULL, max_y REAL NOT NULL, max_z REAL NOT NULL,
    surface_area REAL NOT NULL,
    warnings TEXT NOT NULL,                    -- JSON: [{code, count, message}]
    indexed_at TEXT NOT NULL,                  -- ISO 8601, UTC
    revision INTEGER NOT NULL                  -- at which this row last changed
) STRICT;
CREATE INDEX models_by_content ON models (content_hash);
CREATE INDEX models_by_class ON models (class);
CREATE INDEX models_by_name ON models (name);
CREATE INDEX models_by_revision ON models (revision);

-- The parts of a model, apart so that lists of models do not read over them.
CREATE TABLE signatures (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    signature BLOB NOT NULL
) STRICT;

CREATE TABLE descriptors (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    skeleton BLOB NOT NULL,
    globals BLOB NOT NULL
) STRICT;

CREATE TABLE skeletons (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    skeleton BLOB NOT NULL
) STRICT;

-- The branches of the refined skeleton, in its order; chain codes as readable text.
CREATE TABLE branches (
    model INTEGER NOT NULL REFERENCES models (id) ON DELETE CASCADE,
    branch INTEGER NOT NULL CHECK (branch >= 0),
    node_a INTEGER NOT NULL,
    node_b INTEGER NOT NULL,
    length REAL NOT NULL,                      -- model units
    chain_code TEXT NOT NULL,                  -- 5-element code, '0' to '4'
    PRIMARY KEY (model, branch)
) STRICT, WITHOUT ROWID;

CREATE TABLE previews (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    mesh BLOB NOT NULL
) STRICT;

CREATE TABLE thumbnails (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    png BLOB NOT NULL
) STRICT;

-- Files that could not be indexed; tried again when their contents change.
CREATE TABLE failures (
    path TEXT NOT NULL PRIMARY KEY,
    content_hash TEXT NOT NULL,                -- '' = the file could not be read
    code TEXT NOT NULL,
    message TEXT NOT NULL,
    failed_at TEXT NOT NULL                    -- ISO 8601, UTC
) STRICT, WITHOUT ROWID;
