#pragma once

#include "index/store_impl.h"

// Private to the store: the parts of `verify` that go through whole tables.

namespace ossuary::index {

/// Whether tables and indexes are those that the migrations up to its version make.
void verify_schema(Store::Impl& impl, VerifyReport& report);

/// Rows against their checksums, see store_checksum.h.
void verify_checksums(Store::Impl& impl, VerifyReport& report);

/// Uploads and the bytes of those that wait.
void verify_uploads(Store::Impl& impl, VerifyReport& report);

/// The blocks that searches look at against the models and what is stored of them.
void verify_scan(Store::Impl& impl, VerifyReport& report);

}  // namespace ossuary::index
