// Feeds arbitrary bytes to the reader of classification files.

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "engine/ranking/classification.h"
#include "tests/fuzz/require.h"

namespace {

using ossuary::fuzz::require;

void check(const ossuary::ranking::Classification& classification) {
    std::set<std::string> classes, models;
    for (const auto& entry : classification.classes) {
        require(entry.parent.empty() || classes.contains(entry.parent));
        require(classes.insert(entry.name).second);
        for (const std::string& id : entry.models) require(models.insert(id).second);
        const std::string full = ossuary::ranking::full_class_name(classification, entry.name);
        require(full.ends_with(entry.name));
    }
    require(classification.model_count() == models.size());
    require(ossuary::ranking::models_in_order(classification).size() == models.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto parsed = ossuary::ranking::parse_classification(bytes, "input");
    if (parsed) {
        check(*parsed);
    } else {
        require(parsed.error().code == ossuary::ErrorCode::kClaInvalid);
        require(!parsed.error().message.empty());
    }
    return 0;
}
