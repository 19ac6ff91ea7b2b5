-- Local features of a model's surface, by which pieces of it are found. Models that were indexed
-- before this have none, nor has a model without area.
CREATE TABLE surface_features (
    model INTEGER NOT NULL PRIMARY KEY REFERENCES models (id) ON DELETE CASCADE,
    features BLOB NOT NULL
) STRICT;
