// Feeds arbitrary queries to the parameters of a search, through the guard as in the server.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "server/parameters.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ossuary::server;
    using ossuary::fuzz::require;

    const std::string_view query(reinterpret_cast<const char*>(data), size);
    const auto head = check_head("POST /api/v1/search?" + std::string(query) +
                                 " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n");
    if (!head) return 0;
    ParameterReader reader(*head);
    const ossuary::index::SearchOptions options = read_search_options(reader);
    if (const auto fault = reader.finish()) {
        require(fault->row.status == 400 && !fault->detail.empty());
        return 0;
    }
    require(options.limit >= 1 && options.limit <= 1000);
    require(options.rank.pose >= 0 && options.rank.pose <= 1);
    return 0;
}
