#pragma once

#include <vector>

#include "engine/decomposition/segmentation.h"

namespace ossuary::decomposition {

/// How far two segmentations of one mesh are apart, as Chen, Golovinskiy and Funkhouser, "A
/// Benchmark for 3D Mesh Segmentation", 2009, sec. 4, define it and their evaluator computes it.
/// All are in [0, 1], 0 for equal segmentations, and symmetric but for the two rates.
/// Cut discrepancy, the fifth measure, needs the surface: cut_discrepancy.h.
struct SegmentationErrors {
    /// 1 - Rand index: the share of the pairs of faces that one segmentation puts into one part
    /// and the other into two. Every face counts the same, whatever its area.
    double rand_index_error = 0.0;
    /// Mean of the two rates below (Huang and Dom, 1995).
    double hamming = 0.0;
    /// The share of the area left over when each part of the reference is covered by the one part
    /// of the segmentation that shares most area with it.
    double hamming_missing = 0.0;
    /// The same the other way round.
    double hamming_false_alarm = 0.0;
    /// Martin et al., 2001. The refinement error of a face is the share of its part in one
    /// segmentation that is not in its part in the other. Global: the mean over the faces in the
    /// better direction; local: in the better direction for each face. Parts are measured by their
    /// faces, or by area in the `_area` variants (whose mean is over faces as well). 0 where
    /// either has one part only or a part for each face.
    double global_consistency = 0.0;
    double local_consistency = 0.0;
    double global_consistency_area = 0.0;
    double local_consistency_area = 0.0;
};

/// @param reference, segmentation  a label for each face, of equal size
/// @param areas  of the faces, of the same size; all 0 makes the Hamming distance 0
SegmentationErrors segmentation_errors(const Segmentation& reference,
                                       const Segmentation& segmentation,
                                       const std::vector<double>& areas);

}  // namespace ossuary::decomposition
