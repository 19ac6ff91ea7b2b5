#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/decomposition/segmentation.h"
#include "engine/mesh/triangle_mesh.h"
#include "index/segmentation_evaluation.h"

namespace ossuary::index {

/// Colours for the parts of a segmentation that fit those of a reference: a part has the colour of
/// the part of the reference that it shares most area with, unless a larger one has taken it.
/// @param reference, segmentation  a label for each triangle of the mesh
/// @returns the number of a colour (part_colour) for each part of the segmentation
std::vector<std::uint32_t> matching_colours(const mesh::TriangleMesh& mesh,
                                            const decomposition::Segmentation& reference,
                                            const decomposition::Segmentation& segmentation);

/// One model cut in several ways.
struct SheetRow {
    mesh::TriangleMesh mesh;
    /// A label for each triangle; the first gives the colours of the others.
    std::vector<decomposition::Segmentation> segmentations;
};

/// Models in coloured parts as a PNG file on white: a row a model, a column a segmentation; above
/// eight rows in two stacks beside each other.
/// @pre every row has as many segmentations as the first
/// Errors: invalid_argument (no rows, or more than fit into a picture), those of render_pixels.
Result<std::vector<std::uint8_t>> parts_sheet(const std::vector<SheetRow>& rows, int cell_pixels);

/// The first model of each class of an evaluation (the first twelve models where there are no
/// classes): the parts of the first person, of the thesis' method, of ours, and those that were
/// evaluated where they were read from a folder.
/// Errors: those of parts_sheet, of reading and of decompose.
Result<std::vector<std::uint8_t>> evaluation_sheet(const SegmentationEvaluationOptions& options,
                                                   const SegmentationEvaluation& evaluation,
                                                   int cell_pixels);

}  // namespace ossuary::index
