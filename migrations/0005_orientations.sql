-- Which axis of a model's file points up; its thumbnail is drawn by it. Models that were indexed
-- before this have no row and y up.
CREATE TABLE orientations (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    up TEXT NOT NULL CHECK (up IN ('y', 'z')),
    said_by TEXT NOT NULL CHECK (said_by IN ('program', 'person'))
) STRICT;
