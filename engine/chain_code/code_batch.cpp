#include "engine/chain_code/code_batch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace ossuary::chain_code {
namespace {

constexpr std::size_t kLanes = CodeBatch::kLanes;
using Row = std::array<std::int16_t, (kMaxAlignedSteps + 1) * kLanes>;

std::int16_t narrow(int value) { return static_cast<std::int16_t>(value); }

/// One row of the dynamic programme for eight alignments: `row` turns from the costs of the steps
/// before into those with a step of this level. Plain loops over the lanes, which the compiler
/// makes vector instructions of; arithmetic stays within 16 bits (see AlignmentCosts).
struct RowCosts {
    std::int16_t level;
    std::int16_t gap;
    std::int16_t slope;
    std::int16_t limit_levels;
    std::int16_t limit;
};

void advance(Row& row, std::size_t columns, const RowCosts& costs,
             const std::int16_t* direction_costs, const std::int16_t* levels) {
    alignas(16) std::int16_t diagonal[kLanes];
    alignas(16) std::int16_t left[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        diagonal[lane] = row[lane];
        left[lane] = narrow(row[lane] + costs.gap);
        row[lane] = left[lane];
    }
    for (std::size_t column = 0; column < columns; ++column) {
        std::int16_t* above = row.data() + (column + 1) * kLanes;
        const std::int16_t* direction_cost = direction_costs + column * kLanes;
        const std::int16_t* level = levels + column * kLanes;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::int16_t up = above[lane];
            const std::int16_t difference = narrow(level[lane] - costs.level);
            const std::int16_t negated = narrow(-difference);
            const std::int16_t distance = std::max(difference, negated);
            const std::int16_t bounded = std::min(distance, costs.limit_levels);
            const std::int16_t radius = std::min(narrow(bounded * costs.slope), costs.limit);
            const std::int16_t exchanged = narrow(diagonal[lane] + direction_cost[lane] + radius);
            const std::int16_t gapped = narrow(std::min(up, left[lane]) + costs.gap);
            diagonal[lane] = up;
            left[lane] = std::min(exchanged, gapped);
            above[lane] = left[lane];
        }
    }
}

}  // namespace

CodeBatch::CodeBatch(std::span<const std::span<const DirectionStep>> codes) {
    slots_.resize(codes.size());
    std::vector<std::uint32_t> by_length(codes.size());
    std::iota(by_length.begin(), by_length.end(), 0U);
    std::stable_sort(by_length.begin(), by_length.end(), [&](std::uint32_t x, std::uint32_t y) {
        return codes[x].size() > codes[y].size();
    });
    for (std::size_t first = 0; first < by_length.size(); first += kLanes) {
        Group group;
        group.first_column = static_cast<std::uint32_t>(columns());
        group.columns = static_cast<std::uint32_t>(codes[by_length[first]].size());
        assert(group.columns <= kMaxAlignedSteps);
        directions_.resize(directions_.size() + group.columns * kLanes, 0);
        levels_.resize(directions_.size(), 0);
        for (std::size_t lane = 0; lane < kLanes && first + lane < by_length.size(); ++lane) {
            const std::uint32_t number = by_length[first + lane];
            const std::span<const DirectionStep> code = codes[number];
            for (std::size_t step = 0; step < code.size(); ++step) {
                const std::size_t place = (group.first_column + step) * kLanes + lane;
                directions_[place] = code[step].direction;
                levels_[place] = code[step].radius_level;
            }
            slots_[number] = {static_cast<std::uint32_t>(groups_.size()),
                              static_cast<std::uint32_t>(lane),
                              static_cast<std::uint32_t>(code.size())};
        }
        groups_.push_back(group);
    }
}

void BatchAligner::start(const CodeBatch& batch, const AlignmentCosts& costs) {
    batch_ = &batch;
    costs_ = &costs;
    direction_known_.assign(kDirectionCount, 0);
    const std::size_t needed = kDirectionCount * batch.columns() * kLanes;
    if (direction_costs_.size() < needed) direction_costs_.resize(needed);
    const std::size_t rows = batch.groups().size() * (kMaxAlignedSteps + 1) * kLanes;
    if (ends_.size() < rows) ends_.resize(rows);
}

const std::int16_t* BatchAligner::direction_costs(std::uint8_t direction) {
    const std::size_t size = batch_->columns() * kLanes;
    std::int16_t* costs = direction_costs_.data() + direction * size;
    if (direction_known_[direction] == 0) {
        const std::uint8_t* directions = batch_->directions(0);
        for (std::size_t i = 0; i < size; ++i) {
            costs[i] = narrow(costs_->direction(direction, directions[i]));
        }
        direction_known_[direction] = 1;
    }
    return costs;
}

void BatchAligner::align(std::span<const DirectionStep> code, std::span<float> results) {
    assert(batch_ != nullptr && results.size() == batch_->size());
    assert(code.size() <= kMaxAlignedSteps);
    RowCosts row_costs{0, narrow(costs_->gap()), narrow(costs_->radius_slope()),
                       narrow(costs_->radius_limit_levels()), narrow(costs_->radius_limit())};
    alignas(16) Row row;
    std::size_t group_number = 0;
    for (const CodeBatch::Group& group : batch_->groups()) {
        for (std::size_t column = 0; column <= group.columns; ++column) {
            std::fill_n(row.data() + column * kLanes, kLanes,
                        narrow(costs_->gap() * static_cast<int>(column)));
        }
        for (const DirectionStep step : code) {
            row_costs.level = step.radius_level;
            advance(row, group.columns, row_costs,
                    direction_costs(step.direction) + group.first_column * kLanes,
                    batch_->levels(group.first_column));
        }
        std::copy_n(row.data(), (group.columns + 1) * kLanes,
                    ends_.data() + group_number++ * row.size());
    }
    for (std::size_t i = 0; i < results.size(); ++i) {
        const CodeBatch::Slot& slot = batch_->slots()[i];
        const std::size_t longer = std::max<std::size_t>(slot.steps, code.size());
        const std::int16_t cost = ends_[slot.group * row.size() + slot.steps * kLanes + slot.lane];
        results[i] =
            longer == 0 ? 0.0F
                        : static_cast<float>(cost / (costs_->unit() * static_cast<double>(longer)));
    }
}

}  // namespace ossuary::chain_code
