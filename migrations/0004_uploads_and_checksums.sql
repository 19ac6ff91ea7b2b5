-- Uploads: accepted models wait here with their bytes, then their outcome stays for a while.
CREATE TABLE uploads (
    id INTEGER NOT NULL PRIMARY KEY AUTOINCREMENT,  -- the job's number
    name TEXT NOT NULL,
    class TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 32),
    size INTEGER NOT NULL CHECK (size >= 0),        -- bytes
    state TEXT NOT NULL CHECK (state IN ('queued', 'running', 'done', 'failed')),
    claimant TEXT NOT NULL DEFAULT '',              -- running: the process that works on it
    attempts INTEGER NOT NULL DEFAULT 0,            -- begun so far
    model INTEGER,                                  -- done: the model, which may be gone since
    code TEXT,                                      -- failed: why
    message TEXT,
    accepted_at TEXT NOT NULL,                      -- ISO 8601, UTC
    finished_at TEXT,
    checksum INTEGER
) STRICT;
CREATE INDEX uploads_by_state ON uploads (state);

-- The bytes of those that are not finished, in pieces, because a value has a largest size.
CREATE TABLE upload_pieces (
    upload INTEGER NOT NULL REFERENCES uploads (id) ON DELETE CASCADE,
    piece INTEGER NOT NULL CHECK (piece >= 0),
    bytes BLOB NOT NULL,
    PRIMARY KEY (upload, piece)
) STRICT;

-- XXH3-64 of the other columns of a row that no blob's checksum covers, see docs/index-format.md.
ALTER TABLE parameters ADD COLUMN checksum INTEGER;
ALTER TABLE state ADD COLUMN checksum INTEGER;
ALTER TABLE models ADD COLUMN checksum INTEGER;
ALTER TABLE failures ADD COLUMN checksum INTEGER;
ALTER TABLE statistics ADD COLUMN checksum INTEGER;
ALTER TABLE evaluations ADD COLUMN checksum INTEGER;
