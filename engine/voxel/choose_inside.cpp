#include "engine/voxel/choose_inside.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mesh/mesh_builder.h"
#include "engine/voxel/volume_values.h"

namespace ossuary::voxel {
namespace {

constexpr std::size_t kMostLabels = 128;
constexpr std::size_t kBins = 1024;

/// What the values of a volume are like.
struct ValueRange {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
    std::set<double> values;  ///< while there are no more than kMostLabels + 1
    std::size_t not_finite = 0;
};

std::optional<ValueRange> look_at_values(const Volume& volume, const std::stop_token& stop) {
    ValueRange range;
    double last = std::numeric_limits<double>::quiet_NaN();
    const bool done = visit_values(volume, stop, [&](const Vec3i&, double value) {
        if (value == last) return;  // most neighbours are equal
        if (!std::isfinite(value)) {
            ++range.not_finite;
            return;
        }
        last = value;
        range.least = std::min(range.least, value);
        range.greatest = std::max(range.greatest, value);
        if (range.values.size() <= kMostLabels) range.values.insert(value);
    });
    return done ? std::optional(std::move(range)) : std::nullopt;
}

bool are_labels(const ValueRange& range) {
    return range.values.size() <= kMostLabels && range.least == 0.0 &&
           std::all_of(range.values.begin(), range.values.end(),
                       [](double value) { return value == std::floor(value); });
}

/// The lower end of the first bin above the cut that leaves the least variance within both groups.
std::optional<double> otsu_threshold(const Volume& volume, const ValueRange& range,
                                     const std::stop_token& stop) {
    std::array<double, kBins> counts{};
    const double width = range.greatest / kBins - range.least / kBins;
    const bool done = visit_values(volume, stop, [&](const Vec3i&, double value) {
        if (!std::isfinite(value)) return;
        const double bin = (value - range.least) / width;
        ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
    });
    if (!done) return std::nullopt;
    double total = 0.0, sum = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        total += counts[bin];
        sum += counts[bin] * static_cast<double>(bin);
    }
    double below = 0.0, sum_below = 0.0, best = -1.0;
    std::size_t cut = 1;
    for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
        below += counts[bin];
        sum_below += counts[bin] * static_cast<double>(bin);
        if (below == 0.0 || below == total) continue;
        const double apart = sum_below / below - (sum - sum_below) / (total - below);
        const double between = below * (total - below) * apart * apart;
        if (between > best) {
            best = between;
            cut = bin + 1;
        }
    }
    return range.least + static_cast<double>(cut) * width;
}

/// What is inside where nobody says so.
Result<Inside> find_inside(const Volume& volume, const ValueRange& range,
                           const std::stop_token& stop) {
    const std::string from_to =
        mesh::number_text(range.least) + " to " + mesh::number_text(range.greatest);
    Inside inside;
    if (range.values.size() == 2) {
        inside.kind = Inside::Kind::kLabel;
        inside.value = range.greatest == 0.0 ? range.least : range.greatest;
        inside.reason = mesh::number_text(inside.value) + ", of two values";
    } else if (are_labels(range)) {
        inside.kind = Inside::Kind::kMask;
        inside.reason = "all values but 0, of " + std::to_string(range.values.size()) +
                        " whole numbers that are taken for labels";
    } else if (range.least == range.greatest) {
        inside.value = range.least;
        inside.reason = "all of it, as there is one value only";
    } else {
        const std::optional<double> threshold = otsu_threshold(volume, range, stop);
        if (!threshold) return {ErrorCode::kCancelled, "reading was cancelled"};
        inside.value = *threshold;
        inside.reason = "values from " + mesh::number_text(*threshold) + " on, of " + from_to;
    }
    return inside;
}

}  // namespace

Result<Inside> choose_inside(const Volume& volume, const InsideOptions& options,
                             const std::stop_token& stop) {
    for (const std::optional<double>& said : {options.label, options.threshold}) {
        if (said && !std::isfinite(*said)) {
            return {ErrorCode::kInvalidArgument, "expected a finite threshold or label"};
        }
    }
    const std::optional<ValueRange> range = look_at_values(volume, stop);
    if (!range) return {ErrorCode::kCancelled, "reading was cancelled"};
    if (range->values.empty()) {
        return {ErrorCode::kSolidEmpty, "expected finite values, found none"};
    }
    Inside inside;
    if (options.label) {
        inside.kind = Inside::Kind::kLabel;
        inside.value = *options.label;
    } else if (options.threshold) {
        inside.value = *options.threshold;
    } else {
        Result<Inside> found = find_inside(volume, *range, stop);
        if (!found) return found;
        inside = *std::move(found);
    }
    inside.least = range->least;
    inside.greatest = range->greatest;
    inside.not_finite = range->not_finite;
    return inside;
}

}  // namespace ossuary::voxel
