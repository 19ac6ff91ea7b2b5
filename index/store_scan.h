#pragma once

#include <cstdint>
#include <map>

#include "engine/ranking/scan_rows.h"
#include "index/scan_block.h"
#include "index/store_connection.h"

// Private to the store: the blocks that searches look at, kept equal to the models.

namespace ossuary::index {

/// The row of each model that is described in this transaction.
using FreshRows = std::map<ModelId, ranking::ScanRows>;

/// A block as the other tables have it: rows that are in neither `fresh` nor `earlier` are made
/// from the stored descriptors.
ScanBlock make_scan_block(Connection& connection, std::int64_t number, const FreshRows& fresh,
                          const ScanBlock* earlier);

/// Makes a block anew, as part of a transaction of this revision that has changed some of its
/// models.
void write_scan_block(Connection& connection, std::int64_t number, Revision revision,
                      const FreshRows& fresh);

/// Writes the blocks of all models, for an index that has none.
void fill_scan_blocks(Connection& connection);

}  // namespace ossuary::index
