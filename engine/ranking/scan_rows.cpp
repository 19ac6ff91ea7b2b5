#include "engine/ranking/scan_rows.h"

#include <algorithm>
#include <cmath>

#include "engine/ranking/fusion.h"
#include "engine/ranking/normalization.h"

namespace ossuary::ranking {
namespace {

/// A signature's values are at most 0.4 for the Princeton models.
constexpr float kByteScale = 600.0F;

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(std::round(kByteScale * value), 0.0F, 255.0F));
}

template <typename T>
void extend(std::vector<T>& values, const auto& more) {
    values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

std::vector<std::uint8_t> signature_bytes(std::span<const float> signature) {
    std::vector<std::uint8_t> bytes(descriptor::kSignatureSize, 0);
    const std::size_t size = std::min(signature.size(), bytes.size());
    std::transform(signature.begin(), signature.begin() + static_cast<std::ptrdiff_t>(size),
                   bytes.begin(), to_byte);
    return bytes;
}

void ScanRows::append(const ScanRow& row) {
    extend(signatures, row.signature);
    extend(sketches, row.sketch);
    informations.push_back(row.information);
    keys.push_back(row.key);
}

void ScanRows::append(const descriptor::ModelDescriptor& model) {
    extend(signatures, signature_bytes(model.signature));
    extend(sketches, sketch_of(model.globals));
    informations.push_back(static_cast<float>(skeleton_information(model.skeleton)));
    keys.push_back(model_key(model));
}

void ScanRows::append(const ScanRows& other) {
    extend(signatures, other.signatures);
    extend(sketches, other.sketches);
    extend(informations, other.informations);
    extend(keys, other.keys);
}

}  // namespace ossuary::ranking
