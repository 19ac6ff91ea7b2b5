#include "engine/decomposition/segmentation_metrics.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace ossuary::decomposition {
namespace {

/// How much each part of one segmentation shares with each part of the other, by faces or by area.
struct Overlap {
    std::size_t rows = 0;     ///< parts of the reference
    std::size_t columns = 0;  ///< parts of the segmentation
    std::vector<double> shared;
    std::vector<double> row_sums;
    std::vector<double> column_sums;
    double total = 0.0;

    template <typename Weight>
    Overlap(const Segmentation& reference, const Segmentation& segmentation, Weight weight)
        : rows(reference.parts),
          columns(segmentation.parts),
          shared(rows * columns, 0.0),
          row_sums(rows, 0.0),
          column_sums(columns, 0.0) {
        for (std::size_t face = 0; face < reference.labels.size(); ++face) {
            const double w = weight(face);
            shared[reference.labels[face] * columns + segmentation.labels[face]] += w;
            row_sums[reference.labels[face]] += w;
            column_sums[segmentation.labels[face]] += w;
            total += w;
        }
    }
    [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
        return shared[row * columns + column];
    }
};

double pairs(double n) { return 0.5 * n * (n - 1.0); }

double rand_index_error(const Overlap& faces) {
    if (faces.total < 2.0) return 0.0;
    double differing = 0.0;
    for (const double n : faces.row_sums) differing += pairs(n);
    for (const double n : faces.column_sums) differing += pairs(n);
    for (const double n : faces.shared) differing -= 2.0 * pairs(n);
    return differing / pairs(faces.total);
}

void add_hamming(const Overlap& area, SegmentationErrors& errors) {
    if (area.total <= 0.0) return;
    double covered_reference = 0.0, covered_segmentation = 0.0;
    for (std::size_t i = 0; i < area.rows; ++i) {
        double best = 0.0;
        for (std::size_t j = 0; j < area.columns; ++j) best = std::max(best, area(i, j));
        covered_reference += best;
    }
    for (std::size_t j = 0; j < area.columns; ++j) {
        double best = 0.0;
        for (std::size_t i = 0; i < area.rows; ++i) best = std::max(best, area(i, j));
        covered_segmentation += best;
    }
    errors.hamming_missing = std::max(0.0, 1.0 - covered_reference / area.total);
    errors.hamming_false_alarm = std::max(0.0, 1.0 - covered_segmentation / area.total);
    errors.hamming = 0.5 * (errors.hamming_missing + errors.hamming_false_alarm);
}

struct Consistency {
    double global = 0.0;
    double local = 0.0;
};

Consistency consistency(const Overlap& faces, const Overlap& size) {
    const auto is_trivial = [&](std::size_t parts) {
        return parts <= 1 || static_cast<double>(parts) == faces.total;
    };
    if (is_trivial(faces.rows) || is_trivial(faces.columns)) return {};
    double forth = 0.0, back = 0.0, local = 0.0;
    for (std::size_t i = 0; i < faces.rows; ++i) {
        for (std::size_t j = 0; j < faces.columns; ++j) {
            if (faces(i, j) == 0.0) continue;
            const auto outside = [&](double whole) {
                return whole > 0.0 ? 1.0 - size(i, j) / whole : 0.0;
            };
            const double row = outside(size.row_sums[i]), column = outside(size.column_sums[j]);
            forth += row * faces(i, j);
            back += column * faces(i, j);
            local += std::min(row, column) * faces(i, j);
        }
    }
    return {std::min(forth, back) / faces.total, local / faces.total};
}

}  // namespace

SegmentationErrors segmentation_errors(const Segmentation& reference,
                                       const Segmentation& segmentation,
                                       const std::vector<double>& areas) {
    assert(reference.labels.size() == segmentation.labels.size());
    assert(reference.labels.size() == areas.size());
    const Overlap faces(reference, segmentation, [](std::size_t) { return 1.0; });
    const Overlap area(reference, segmentation, [&](std::size_t face) { return areas[face]; });
    SegmentationErrors errors;
    errors.rand_index_error = rand_index_error(faces);
    add_hamming(area, errors);
    const Consistency by_faces = consistency(faces, faces);
    errors.global_consistency = by_faces.global;
    errors.local_consistency = by_faces.local;
    const Consistency by_area = consistency(faces, area);
    errors.global_consistency_area = by_area.global;
    errors.local_consistency_area = by_area.local;
    return errors;
}

}  // namespace ossuary::decomposition
