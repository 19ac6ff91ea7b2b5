#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/model_descriptor.h"
#include "engine/descriptor/signature.h"
#include "engine/ranking/sketch.h"

namespace ossuary::ranking {

/// A preselection signature, a byte a value. On the Princeton collections the L1 distance of bytes
/// finds the nearest models better than the Euclidean one of floats (first tier of all 19 classes
/// .692 against .650).
[[nodiscard]] std::vector<std::uint8_t> signature_bytes(std::span<const float> signature);

/// What a scan knows of one model.
struct ScanRow {
    std::span<const std::uint8_t> signature;  ///< kSignatureSize bytes
    std::span<const std::uint8_t> sketch;     ///< kSketchSize bytes
    float information = 0.0F;                 ///< skeleton_information
    std::uint64_t key = 0;                    ///< model_key, by which statistics know a model
};

/// The rows of some models, in flat arrays: `size()` times what ScanRow holds.
struct ScanRows {
    std::vector<std::uint8_t> signatures;
    std::vector<std::uint8_t> sketches;
    std::vector<float> informations;
    std::vector<std::uint64_t> keys;

    [[nodiscard]] std::size_t size() const { return keys.size(); }
    [[nodiscard]] ScanRow row(std::size_t at) const {
        return {std::span(signatures)
                    .subspan(at * descriptor::kSignatureSize, descriptor::kSignatureSize),
                std::span(sketches).subspan(at * kSketchSize, kSketchSize), informations[at],
                keys[at]};
    }
    void append(const ScanRow& row);
    void append(const descriptor::ModelDescriptor& model);
    void append(const ScanRows& other);
};

}  // namespace ossuary::ranking
