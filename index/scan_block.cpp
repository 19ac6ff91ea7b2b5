#include "index/scan_block.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>

#include "index/blob.h"
#include "index/bytes.h"

namespace ossuary::index {

namespace {

/// Of each model, without signature and sketch.
constexpr std::size_t kNumbersSize = 8 + 8 + 8 + 4 + 4 + 8;

std::string_view text_of(const std::vector<std::uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::uint8_t> get_bytes(ByteReader& reader, std::size_t count) {
    const std::string_view raw = reader.get_raw(count);
    return {raw.begin(), raw.end()};
}

}  // namespace

void ScanBlock::append(ModelId id, Revision revision, std::uint64_t measures_of_it,
                       std::string_view class_name) {
    ids.push_back(id);
    changed_at.push_back(revision);
    measures.push_back(measures_of_it);
    const auto known = std::find(class_names.begin(), class_names.end(), class_name);
    classes.push_back(static_cast<std::uint32_t>(known - class_names.begin()));
    if (known == class_names.end()) class_names.emplace_back(class_name);
}

std::uint64_t measures_key(std::uint32_t vertices, std::uint32_t faces, double surface_area,
                           const Box3& bounds) {
    ByteWriter writer;
    writer.put(vertices);
    writer.put(faces);
    // Zero has two signs.
    writer.put(surface_area + 0.0);
    for (const Vec3& corner : {bounds.min(), bounds.max()}) {
        for (int axis = 0; axis < 3; ++axis) writer.put(corner[axis] + 0.0);
    }
    return XXH3_64bits(writer.bytes().data(), writer.bytes().size());
}

std::string encode_scan_block(const ScanBlock& block) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(descriptor::kSignatureSize));
    writer.put(static_cast<std::uint32_t>(ranking::kSketchSize));
    writer.put(static_cast<std::uint32_t>(block.class_names.size()));
    for (const std::string& name : block.class_names) writer.put_text(name);
    writer.put(static_cast<std::uint32_t>(block.size()));
    writer.put_all<ModelId>(block.ids);
    writer.put_all<Revision>(block.changed_at);
    writer.put_all<std::uint64_t>(block.measures);
    writer.put_all<std::uint32_t>(block.classes);
    writer.put_all<float>(block.rows.informations);
    writer.put_all<std::uint64_t>(block.rows.keys);
    writer.put_raw(text_of(block.rows.signatures));
    writer.put_raw(text_of(block.rows.sketches));
    return seal_blob(kScanBlob, writer.bytes());
}

Result<ScanBlock> decode_scan_block(std::string_view blob) {
    const auto payload = open_blob(kScanBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    const auto signature = reader.get<std::uint32_t>();
    const auto sketch = reader.get<std::uint32_t>();
    if (signature != descriptor::kSignatureSize || sketch != ranking::kSketchSize) {
        return corrupt_blob(kScanBlob, "signatures or sketches of another length");
    }
    ScanBlock block;
    block.class_names.resize(reader.get_count(4));
    for (std::string& name : block.class_names) name = reader.get_text();
    const std::size_t count = reader.get_count(kNumbersSize + signature + sketch);
    block.ids = reader.get_all<ModelId>(count);
    block.changed_at = reader.get_all<Revision>(count);
    block.measures = reader.get_all<std::uint64_t>(count);
    block.classes = reader.get_all<std::uint32_t>(count);
    block.rows.informations = reader.get_all<float>(count);
    block.rows.keys = reader.get_all<std::uint64_t>(count);
    block.rows.signatures = get_bytes(reader, count * signature);
    block.rows.sketches = get_bytes(reader, count * sketch);
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kScanBlob, "wrong length");
    if (std::adjacent_find(block.ids.begin(), block.ids.end(), std::greater_equal<>()) !=
        block.ids.end()) {
        return corrupt_blob(kScanBlob, "ids that do not ascend");
    }
    if (std::any_of(block.classes.begin(), block.classes.end(),
                    [&](std::uint32_t number) { return number >= block.class_names.size(); })) {
        return corrupt_blob(kScanBlob, "a class that is not there");
    }
    if (std::any_of(block.rows.informations.begin(), block.rows.informations.end(),
                    [](float value) { return !(value >= 0.0F && value <= 1.0F); })) {
        return corrupt_blob(kScanBlob, "a share outside 0 to 1");
    }
    return block;
}

}  // namespace ossuary::index
