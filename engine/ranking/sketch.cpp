#include "engine/ranking/sketch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/descriptor/body_size.h"
#include "engine/descriptor/byte_distance.h"

namespace ossuary::ranking {
namespace {

using descriptor::GlobalPlace;

constexpr std::uint16_t kNone = 0xFFFF;

/// One global descriptor's share in a sketch: which cell each of its bytes goes to.
struct Part {
    GlobalPlace place;
    std::size_t offset = 0;            ///< in the sketch
    std::size_t size = 0;              ///< cells
    bool is_mean = false;              ///< of its bytes; else the root of the sum of their squares
    double root_scale = 1.0;           ///< of these roots
    std::vector<std::uint16_t> cells;  ///< as long as the descriptor; kNone = left out
};

/// Cells of bytes that are numbered row by row.
class Numbering {
public:
    explicit Numbering(Part& part) : part_(part) {}
    /// The next byte goes to the cell of this mark, a new one at its first mention.
    void to(std::size_t mark) {
        const auto known = std::find(marks_.begin(), marks_.end(), mark);
        part_.cells.push_back(static_cast<std::uint16_t>(
            part_.size + static_cast<std::size_t>(known - marks_.begin())));
        if (known == marks_.end()) marks_.push_back(mark);
    }
    void leave_out() { part_.cells.push_back(kNone); }
    ~Numbering() { part_.size += marks_.size(); }
    Numbering(const Numbering&) = delete;
    Numbering& operator=(const Numbering&) = delete;

private:
    Part& part_;
    std::vector<std::size_t> marks_;
};

/// Every byte its own cell.
void add_all(Part& part, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) part.cells.push_back(static_cast<std::uint16_t>(i));
    part.size = size;
}

/// A histogram of three variables with fewer bins in each.
void add_coarse(Part& part, const std::array<std::size_t, 3>& bins,
                const std::array<std::size_t, 3>& merged) {
    Numbering numbering(part);
    for (std::size_t i = 0; i < bins[0]; ++i) {
        for (std::size_t j = 0; j < bins[1]; ++j) {
            for (std::size_t k = 0; k < bins[2]; ++k) {
                numbering.to((i / merged[0] * 100 + j / merged[1]) * 100 + k / merged[2]);
            }
        }
    }
}

constexpr std::size_t kPairsDistances = 12, kPairsStraightnesses = 3, kPairsRadii = 4;
constexpr std::size_t kViewRows = 4, kViewColumns = 6, kViewDepths = 4;
constexpr std::size_t kViewCells =
    2 * kViewRows * kViewColumns + 4 * kViewDepths * (kViewDepths + 1) / 2;

/// The low frequencies of each view; of depth images those that differ by the order of the image's
/// axes count as one, so that axes may change places without turning anything.
void add_views(Part& part) {
    constexpr std::size_t kPanoramaColumns = 16, kMark = 1000;
    for (std::size_t view = 0; view < 3 * descriptor::kViewFrames; ++view) {
        Numbering numbering(part);
        for (std::size_t i = 0; i < 2 * descriptor::kPanoramaSpectrum; ++i) {
            const std::size_t row = i % descriptor::kPanoramaSpectrum / kPanoramaColumns;
            if (row < kViewRows && i % kPanoramaColumns < kViewColumns) {
                numbering.to(i);
            } else {
                numbering.leave_out();
            }
        }
        for (std::size_t i = 0; i < 4 * descriptor::kDepthSpectrum; ++i) {
            const std::size_t image = i / descriptor::kDepthSpectrum;
            const std::size_t row = i % descriptor::kDepthSpectrum / descriptor::kDepthFrequencies;
            const std::size_t column = i % descriptor::kDepthFrequencies;
            const auto [low, high] = std::minmax(row, column);
            if (high < kViewDepths) {
                numbering.to(kMark * (image + 1) + 10 * low + high);
            } else {
                numbering.leave_out();
            }
        }
    }
    part.is_mean = true;
}

/// Distance against the angle between the normals, and the two other angles.
void add_surface_pairs(Part& first, Part& second) {
    Numbering by_distance(first), by_angles(second);
    for (std::size_t i = 0; i < descriptor::kSurfacePairsSize; ++i) {
        by_distance.to(i / 125 * 5 + i % 5);
        by_angles.to(i / 5 % 25);
    }
    first.root_scale = second.root_scale = 0.5;
}

void add_local_volume(Part& part) {
    constexpr std::size_t kFirst = 12 * 8;
    {
        Numbering by_geodesic(part);
        for (std::size_t i = 0; i < kFirst; ++i) by_geodesic.to(i / 16 * 4 + i % 8 / 2);
    }
    add_coarse(part, {8, 8, 6}, {2, 2, 3});
}

std::vector<Part> make_parts() {
    std::vector<Part> parts;
    const auto add = [&](GlobalPlace place) -> Part& {
        parts.push_back({place, 0, 0, false, 1.0, {}});
        return parts.back();
    };
    add_coarse(add(descriptor::kSkeletonPairsPlace),
               {kPairsDistances, 2 * kPairsStraightnesses, kPairsRadii}, {1, 2, 1});
    add_coarse(add(descriptor::kSkeletonLayoutPlace), {7, 7, 7}, {2, 2, 2});
    add_views(add(descriptor::kViewsPlace));
    Part by_distance = add(descriptor::kSurfacePairsPlace);
    parts.pop_back();
    Part by_angles = by_distance;
    add_surface_pairs(by_distance, by_angles);
    parts.push_back(std::move(by_distance));
    parts.push_back(std::move(by_angles));
    add_local_volume(add(descriptor::kLocalVolumePlace));
    add_coarse(add(descriptor::kRadialThicknessPlace), {12, 10, 5}, {2, 2, 3});
    add_all(add(descriptor::kThicknessPlace), descriptor::kThicknessSize);
    add_coarse(add(descriptor::kThicknessPairsPlace), {8, 8, 8}, {2, 2, 2});
    add_all(add(descriptor::kBodySizePlace), descriptor::kBodySizeSize);
    std::size_t offset = 0;
    for (Part& part : parts) {
        part.offset = offset;
        offset += part.size;
    }
    assert(offset == kSketchSize);
    return parts;
}

/// What a part's distances are multiplied by, in the order of parts and without the size, to be
/// about those of the whole descriptor: the ratio of the means over all pairs of 682 models.
constexpr std::array kPartScales = {1.407, 2.831, 3.883, 3.324, 3.324, 3.032, 2.884, 1.0, 2.624};

const std::vector<Part>& parts() {
    static const std::vector<Part> kParts = make_parts();
    return kParts;
}

void sketch_part(const Part& part, std::span<const std::uint8_t> values, std::uint8_t* cells) {
    std::vector<double> sums(part.size, 0.0), counts(part.size, 0.0);
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
        const std::uint16_t cell = part.cells[i];
        if (cell == kNone) continue;
        const auto value = static_cast<double>(values[i]);
        sums[cell] += part.is_mean ? value : value * value;
        counts[cell] += 1.0;
    }
    for (std::size_t cell = 0; cell < part.size; ++cell) {
        const double value =
            part.is_mean ? sums[cell] / counts[cell] : part.root_scale * std::sqrt(sums[cell]);
        cells[cell] = static_cast<std::uint8_t>(std::min(255.0, std::round(value)));
    }
}

/// The sum of absolute differences of the squares.
double squared_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t count) {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += std::abs(int{a[i]} * int{a[i]} - int{b[i]} * int{b[i]});
    }
    return static_cast<double>(sum);
}

/// For each frame the least distance over the orders of its axes, as view_distance has it.
double views_distance(const std::uint8_t* a, const std::uint8_t* b) {
    std::uint32_t sum = 0;
    for (std::size_t frame = 0; frame < descriptor::kViewFrames; ++frame) {
        const std::uint8_t* own = a + frame * 3 * kViewCells;
        const std::uint8_t* other = b + frame * 3 * kViewCells;
        std::array<std::array<std::uint32_t, 3>, 3> each{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                each[i][j] = descriptor::byte_distance(own + i * kViewCells, other + j * kViewCells,
                                                       kViewCells);
            }
        }
        std::uint32_t best = each[0][0] + each[1][1] + each[2][2];
        for (std::size_t shift = 0; shift < 3; ++shift) {
            const std::size_t second = (shift + 1) % 3, third = (shift + 2) % 3;
            best = std::min({best, each[0][shift] + each[1][second] + each[2][third],
                             each[0][shift] + each[1][third] + each[2][second]});
        }
        sum += best;
    }
    return static_cast<double>(sum);
}

double part_distance(const Part& part, const std::uint8_t* a, const std::uint8_t* b) {
    if (part.place == descriptor::kViewsPlace) return views_distance(a, b);
    if (part.place == descriptor::kSurfacePairsPlace) return squared_distance(a, b, part.size);
    return static_cast<double>(descriptor::byte_distance(a, b, part.size));
}

/// The pairs of the skeleton's points as build has them, without straightness.
double pairs_without_straightness(const std::uint8_t* a, const std::uint8_t* b) {
    const auto root_of = [](const std::uint8_t* at) {
        double mass = 0.0;
        for (std::size_t k = 0; k < kPairsStraightnesses; ++k) {
            const auto root = static_cast<double>(at[k * kPairsRadii]);
            mass += root * root;
        }
        return std::sqrt(mass);
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < kPairsDistances; ++i) {
        for (std::size_t radius = 0; radius < kPairsRadii; ++radius) {
            const std::size_t at = i * kPairsStraightnesses * kPairsRadii + radius;
            sum += std::abs(root_of(a + at) - root_of(b + at));
        }
    }
    return sum * std::sqrt(2.0 * kPairsStraightnesses);
}

}  // namespace

Sketch sketch_of(const std::vector<descriptor::GlobalDescriptor>& globals) {
    Sketch sketch{};
    for (const Part& part : parts()) {
        // Those of another version are infinitely far from all; here they look empty.
        if (globals.size() <= part.place) continue;
        const std::vector<std::uint8_t>& values = globals[part.place].values;
        if (values.size() != part.cells.size()) continue;
        sketch_part(part, values, sketch.data() + part.offset);
    }
    return sketch;
}

ComponentValues sketch_components(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                                  const RankOptions& options) {
    assert(a.size() == kSketchSize && b.size() == kSketchSize);
    const std::vector<Part>& all = parts();
    ComponentValues values{};
    double thickness = 0.0, thickness_pairs = 0.0;
    const bool with_build = options.pose < kDefaultPose;
    const bool with_kind = options.pose > 0.0 && options.pose < 1.0;  // as PairMeter has it
    for (std::size_t i = 0; i < kPartScales.size(); ++i) {
        const Part& part = all[i];
        const std::size_t component = 1 + part.place;
        const bool is_build = component >= kBuildComponent;
        if (is_build ? !with_build : !(with_kind && fuses(options.ranker, component))) continue;
        const std::uint8_t* cells = a.data() + part.offset;
        const std::uint8_t* others = b.data() + part.offset;
        const double distance = kPartScales[i] * part_distance(part, cells, others);
        if (part.place == descriptor::kThicknessPlace) {
            thickness = distance;
        } else if (part.place == descriptor::kThicknessPairsPlace) {
            thickness_pairs = distance;
        } else {
            values[component] += distance;
        }
    }
    if (with_build) {
        values[kBuildComponent] =
            build_of(thickness, thickness_pairs, pairs_without_straightness(a.data(), b.data()));
    }
    if (options.size > 0.0) {
        const Part& size = all.back();
        values[kSizeComponent] = descriptor::body_size_distance(a.subspan(size.offset, size.size),
                                                                b.subspan(size.offset, size.size));
    }
    return values;
}

}  // namespace ossuary::ranking
