#pragma once

#include "server/connection.h"
#include "server/http_shared.h"

namespace ossuary::server {

/// Serves the requests of one connection, one after the other, until either side ends it.
void serve_connection(HttpShared& shared, Connection& connection);

}  // namespace ossuary::server
