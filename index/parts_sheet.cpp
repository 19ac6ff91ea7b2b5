#include "index/parts_sheet.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "engine/decomposition/decompose.h"
#include "engine/decomposition/seg_file.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "index/coloured_parts.h"
#include "index/thumbnail/png_bytes.h"
#include "index/thumbnail/thumbnail.h"

namespace ossuary::index {
namespace {

constexpr std::size_t kMostRowsInAStack = 8;
constexpr std::size_t kModelsWithoutClasses = 12;
constexpr std::size_t kMostCells = 400;
constexpr std::uint8_t kWhite = 255;

/// Pixels of a sheet that pictures are laid into.
class Sheet {
public:
    Sheet(std::size_t columns, std::size_t rows, std::size_t cell)
        : cell_(cell),
          width_(columns * cell),
          height_(rows * cell),
          bytes_(3 * width_ * height_, kWhite) {}

    void lay(const PixelPicture& picture, std::size_t column, std::size_t row) {
        for (std::size_t y = 0; y < cell_; ++y) {
            const auto from = picture.bytes.begin() + static_cast<std::ptrdiff_t>(3 * cell_ * y);
            const std::size_t to = 3 * ((row * cell_ + y) * width_ + column * cell_);
            std::copy_n(from, 3 * cell_, bytes_.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }
    [[nodiscard]] Result<std::vector<std::uint8_t>> png() const {
        return png_bytes(bytes_, static_cast<int>(width_), static_cast<int>(height_), 3);
    }

private:
    std::size_t cell_;
    std::size_t width_;
    std::size_t height_;
    std::vector<std::uint8_t> bytes_;
};

Result<PixelPicture> draw(const SheetRow& row, std::size_t column, int cell_pixels) {
    const decomposition::Segmentation& segmentation = row.segmentations[column];
    const std::vector<std::uint32_t> colours =
        matching_colours(row.mesh, row.segmentations[0], segmentation);
    ThumbnailOptions options{.size = cell_pixels};
    options.background = {kWhite, kWhite, kWhite};
    options.triangle_colors.reserve(segmentation.labels.size());
    for (const std::uint32_t label : segmentation.labels) {
        options.triangle_colors.push_back(part_colour(colours[label]));
    }
    return render_pixels(row.mesh, options);
}

Result<SheetRow> row_of(const SegmentationEvaluationOptions& options,
                        const SegmentationEvaluation::Model& model) {
    auto read = mesh::read_mesh(options.models / (model.id + ".off"));
    if (!read.ok()) return read.error();
    SheetRow row{std::move(read->mesh), {}};
    const auto people =
        decomposition::read_segmentations(options.truth, model.id, row.mesh.face_count);
    if (!people.ok()) return people.error();
    assert(!people->empty());  // a model without people's parts is not evaluated
    row.segmentations.push_back(decomposition::triangle_segmentation(row.mesh, people->front()));
    for (const auto method : {decomposition::DecompositionMethod::kThesis,
                              decomposition::DecompositionMethod::kEvidence}) {
        const Result<decomposition::Decomposition> made =
            decomposition::decompose(row.mesh, {.method = method});
        if (!made.ok()) return made.error();
        row.segmentations.push_back(made->segmentation);
    }
    if (!options.segmentations.empty()) {
        row.segmentations.push_back(
            decomposition::triangle_segmentation(row.mesh, model.segmentation));
    }
    return row;
}

}  // namespace

std::vector<std::uint32_t> matching_colours(const mesh::TriangleMesh& mesh,
                                            const decomposition::Segmentation& reference,
                                            const decomposition::Segmentation& segmentation) {
    std::vector<double> areas(segmentation.parts, 0.0);
    std::vector<std::map<std::uint32_t, double>> shared(segmentation.parts);
    for (std::size_t t = 0; t < segmentation.labels.size(); ++t) {
        const double area = mesh::triangle_area(mesh, t);
        areas[segmentation.labels[t]] += area;
        shared[segmentation.labels[t]][reference.labels[t]] += area;
    }
    std::vector<std::uint32_t> order(segmentation.parts);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    std::vector<std::uint32_t> colours(segmentation.parts, 0);
    std::set<std::uint32_t> taken;
    std::uint32_t next = reference.parts;
    for (const std::uint32_t part : order) {
        double most = -1.0;
        std::uint32_t colour = next;
        for (const auto& [other, area] : shared[part]) {
            if (area <= most || taken.contains(other)) continue;
            most = area;
            colour = other;
        }
        if (colour == next) ++next;
        taken.insert(colour);
        colours[part] = colour;
    }
    return colours;
}

Result<std::vector<std::uint8_t>> parts_sheet(const std::vector<SheetRow>& rows, int cell_pixels) {
    if (rows.empty() || rows.size() * rows[0].segmentations.size() > kMostCells) {
        return Error{
            ErrorCode::kInvalidArgument,
            "a sheet of parts: expected 1 to " + std::to_string(kMostCells) + " pictures, found " +
                std::to_string(rows.empty() ? 0 : rows.size() * rows[0].segmentations.size())};
    }
    const std::size_t columns = rows[0].segmentations.size();
    const std::size_t stacks = rows.size() > kMostRowsInAStack ? 2 : 1;
    const std::size_t height = (rows.size() + stacks - 1) / stacks;
    Sheet sheet(stacks * columns, height, static_cast<std::size_t>(cell_pixels));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        assert(rows[r].segmentations.size() == columns);
        for (std::size_t c = 0; c < columns; ++c) {
            const Result<PixelPicture> picture = draw(rows[r], c, cell_pixels);
            if (!picture.ok()) return picture.error();
            sheet.lay(*picture, r / height * columns + c, r % height);
        }
    }
    return sheet.png();
}

Result<std::vector<std::uint8_t>> evaluation_sheet(const SegmentationEvaluationOptions& options,
                                                   const SegmentationEvaluation& evaluation,
                                                   int cell_pixels) {
    std::vector<SheetRow> rows;
    std::set<std::string> classes;
    for (const SegmentationEvaluation::Model& model : evaluation.models) {
        const bool is_first = model.class_name.empty() ? rows.size() < kModelsWithoutClasses
                                                       : classes.insert(model.class_name).second;
        if (!is_first) continue;
        Result<SheetRow> row = row_of(options, model);
        if (!row.ok()) return row.error();
        rows.push_back(*std::move(row));
    }
    return parts_sheet(rows, cell_pixels);
}

}  // namespace ossuary::index
