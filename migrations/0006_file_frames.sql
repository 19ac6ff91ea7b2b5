-- What a model's file, or its format, says of its unit and of the axis that points up. Models that
-- were indexed before this have no row.
CREATE TABLE file_frames (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    metres_per_unit REAL CHECK (metres_per_unit > 0),  -- NULL where it names no unit
    up TEXT CHECK (up IN ('x', 'y', 'z')),             -- NULL where it does not say
    checksum INTEGER
) STRICT;

-- Some files say that x points up, and a model may stand so, too.
CREATE TABLE turned (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    up TEXT NOT NULL CHECK (up IN ('x', 'y', 'z')),
    said_by TEXT NOT NULL CHECK (said_by IN ('program', 'person'))
) STRICT;
INSERT INTO turned SELECT model, up, said_by FROM orientations;
DROP TABLE orientations;
ALTER TABLE turned RENAME TO orientations;
