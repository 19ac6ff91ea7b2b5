-- What a search looks at of every model, in blocks of models, so that opening an index reads some
-- thousand blobs in one go and decodes no descriptor. The program fills it: a block is made anew
-- whenever one of its models changes.
CREATE TABLE scan_blocks (
    block INTEGER NOT NULL PRIMARY KEY CHECK (block >= 0),  -- of the models from id 128 * block on
    revision INTEGER NOT NULL,                              -- at which it last changed
    models BLOB NOT NULL
) STRICT;
CREATE INDEX scan_blocks_by_revision ON scan_blocks (revision);
