#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/chain_code/alignment.h"

namespace ossuary::chain_code {

/// Direction codes laid out so that one code is aligned with eight of them at a time: groups of
/// eight codes of similar length, step by step side by side.
class CodeBatch {
public:
    static constexpr std::size_t kLanes = 8;

    struct Group {
        std::uint32_t first_column = 0;  ///< into the columns of eight steps
        std::uint32_t columns = 0;       ///< as many as the longest of the group has steps
    };
    struct Slot {
        std::uint32_t group = 0;
        std::uint32_t lane = 0;
        std::uint32_t steps = 0;
    };

    CodeBatch() = default;
    /// @param codes  each of at most kMaxAlignedSteps steps; a code's number is its place in here
    explicit CodeBatch(std::span<const std::span<const DirectionStep>> codes);

    [[nodiscard]] std::size_t size() const { return slots_.size(); }
    [[nodiscard]] std::size_t columns() const { return directions_.size() / kLanes; }
    [[nodiscard]] std::span<const Group> groups() const { return groups_; }
    [[nodiscard]] std::span<const Slot> slots() const { return slots_; }
    [[nodiscard]] const std::uint8_t* directions(std::size_t column) const {
        return directions_.data() + column * kLanes;
    }
    [[nodiscard]] const std::int16_t* levels(std::size_t column) const {
        return levels_.data() + column * kLanes;
    }

private:
    std::vector<Group> groups_;
    std::vector<Slot> slots_;  // by code
    std::vector<std::uint8_t> directions_;
    std::vector<std::int16_t> levels_;
};

/// Aligns codes with all codes of a batch: what alignment_cost gives for each, bit by bit. Keeps
/// its buffers between calls.
class BatchAligner {
public:
    /// @param batch and costs must outlive the following calls of `align`
    void start(const CodeBatch& batch, const AlignmentCosts& costs);

    /// @param results  one cost for each code of the batch
    void align(std::span<const DirectionStep> code, std::span<float> results);

private:
    const std::int16_t* direction_costs(std::uint8_t direction);

    const CodeBatch* batch_ = nullptr;
    const AlignmentCosts* costs_ = nullptr;
    std::vector<std::int16_t> direction_costs_;  // of each direction with each step of the batch
    std::vector<char> direction_known_;
    std::vector<std::int16_t> ends_;  // last row of the group at hand
};

}  // namespace ossuary::chain_code
