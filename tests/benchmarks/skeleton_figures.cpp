// The thesis' pictures of skeletons (Fig. 3.6, 4.1 to 4.4) with ours, one SVG file each: the model
// as seen through, its skeleton's branches in colours of their own. See kUsage.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "engine/mesh/decimate.h"
#include "engine/mesh/read_mesh.h"
#include "engine/skeleton/skeletonize.h"

namespace {

using namespace ossuary;

constexpr const char* kUsage =
    "usage: ossuary_skeleton_figures OUT FOLDER\n"
    "FOLDER is off/ of the Princeton segmentation benchmark; OUT gets figure-3.6.svg and so on.\n";

constexpr double kPanel = 260.0;
constexpr double kCaption = 18.0;
constexpr std::array<const char*, 8> kColors = {"#c0392b", "#2471a3", "#1e8449", "#b9770e",
                                                "#7d3c98", "#117a65", "#d35400", "#2c3e50"};

struct Model {
    std::string name;
    ossuary::mesh::TriangleMesh mesh;
    ossuary::skeleton::Skeleton skeleton;
    std::vector<Vec3> surface;  ///< the vertices in voxels
};

Model load(const std::filesystem::path& folder, int number) {
    const std::filesystem::path path = folder / fmt::format("{}.off", number);
    Result<ossuary::mesh::ReadMeshResult> read = ossuary::mesh::read_mesh(path);
    if (!read) throw std::runtime_error(read.error().message);
    Result<ossuary::skeleton::Skeleton> skeleton = ossuary::skeleton::skeletonize(read->mesh);
    if (!skeleton) throw std::runtime_error(skeleton.error().message);
    Model model{path.stem().string(), std::move(read->mesh), *std::move(skeleton), {}};
    for (const Vec3& vertex : model.mesh.vertices) {
        model.surface.push_back(model.skeleton.solid.world_from_grid.grid(vertex));
    }
    return model;
}

ossuary::skeleton::SkeletonGraph refined_by(const Model& model,
                                            const ossuary::skeleton::RefineOptions& options) {
    return ossuary::skeleton::refine(model.skeleton.thinned, model.surface, options).refined;
}

/// Panels in rows, each a model and a skeleton in the grid's x-y plane, y upwards: the grid lies
/// along the model's principal axes, so that this is its broad side.
class Picture {
public:
    explicit Picture(int columns) : columns_(columns) {}

    void add(const Model& model, const ossuary::skeleton::SkeletonGraph& graph,
             const std::string& caption) {
        const Vec3i size = model.skeleton.solid.volume.size();
        const int row = count_ / columns_;
        const double scale = kPanel / std::max(size.x(), size.y());
        const double left = kPanel * (count_ % columns_) + (kPanel - scale * size.x()) / 2;
        const double top = (kPanel + kCaption) * row;
        const auto at = [&](const Vec3& p) {
            return fmt::format("{:.1f},{:.1f}", left + scale * p.x(),
                               top + (kPanel + scale * size.y()) / 2 - scale * p.y());
        };
        body_ += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n",
                             kPanel * (count_ % columns_) + kPanel / 2, top + kPanel + 12, caption);
        const ossuary::mesh::TriangleMesh coarse = ossuary::mesh::decimate(model.mesh);
        for (const auto& triangle : coarse.triangles) {
            body_ += "<polygon points=\"";
            for (const std::uint32_t v : triangle) {
                body_ += at(model.skeleton.solid.world_from_grid.grid(coarse.vertices[v])) + " ";
            }
            body_ += "\"/>\n";
        }
        for (std::size_t b = 0; b < graph.branches.size(); ++b) {
            body_ += fmt::format("<polyline stroke=\"{}\" points=\"", kColors[b % kColors.size()]);
            for (const Vec3& point : graph.branches[b].points) body_ += at(point) + " ";
            body_ += "\"/>\n";
        }
        ++count_;
    }

    void write(const std::filesystem::path& path) const {
        const int rows = (count_ + columns_ - 1) / columns_;
        std::ofstream out(path);
        out << fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n"
            "<style>polygon{{fill:#5d6d7e;fill-opacity:.07}}polyline{{fill:none;stroke-width:2;"
            "stroke-linejoin:round}}text{{font:12px sans-serif;text-anchor:middle}}</style>\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
            kPanel * columns_, (kPanel + kCaption) * rows);
        out << body_ << "</svg>\n";
        if (!out.flush()) throw std::runtime_error(path.string() + ": cannot write");
        std::cout << path.string() << '\n';
    }

private:
    int columns_;
    int count_ = 0;
    std::string body_;
};

/// Gaussians of growing width on the raw skeleton.
void figure_3_6(const Model& model, const std::filesystem::path& out) {
    Picture picture(5);
    picture.add(model, model.skeleton.thinned, "raw");
    for (const double variance : {1.0, 4.0, 16.0, 64.0}) {
        ossuary::skeleton::RefineOptions options;
        options.pruning = ossuary::skeleton::PruningMethod::kNone;
        options.merge_junctions = false;
        options.presmooth_variance = variance;
        options.smoothing_scale = ossuary::skeleton::SmoothingScale::kFixed;
        picture.add(model, refined_by(model, options), fmt::format("t = {}", variance));
    }
    picture.write(out / "figure-3.6.svg");
}

/// Raw and refined skeletons.
void figures_4_1_and_4_2(const std::vector<Model>& models, const std::filesystem::path& out) {
    Picture side_by_side(2);
    Picture with_thesis(3);
    ossuary::skeleton::RefineOptions thesis;
    thesis.pruning = ossuary::skeleton::PruningMethod::kSignificance;
    thesis.merge_junctions = false;
    for (const Model& model : models) {
        side_by_side.add(model, model.skeleton.thinned, model.name + ", raw");
        side_by_side.add(model, model.skeleton.refined, model.name + ", refined");
        with_thesis.add(model, model.skeleton.thinned, model.name + ", raw");
        with_thesis.add(model, refined_by(model, thesis),
                        model.name + ", refined as in the thesis");
        with_thesis.add(model, model.skeleton.refined, model.name + ", refined");
    }
    side_by_side.write(out / "figure-4.1.svg");
    with_thesis.write(out / "figure-4.2.svg");
}

/// What pruning takes away.
void figure_4_3(const std::vector<Model>& models, const std::filesystem::path& out) {
    Picture picture(2);
    for (const Model& model : models) {
        const auto caption = [&](const char* stage, const ossuary::skeleton::SkeletonGraph& graph) {
            return fmt::format("{}, {}: {} branches", model.name, stage, graph.branches.size());
        };
        picture.add(model, model.skeleton.thinned, caption("raw", model.skeleton.thinned));
        picture.add(model, model.skeleton.pruned, caption("pruned", model.skeleton.pruned));
    }
    picture.write(out / "figure-4.3.svg");
}

void run(const std::filesystem::path& out, const std::filesystem::path& folder) {
    std::filesystem::create_directories(out);
    std::vector<Model> models;  // one of each of the thesis' ten classes
    for (const int number : {5, 61, 81, 125, 165, 185, 225, 281, 325, 393}) {
        models.push_back(load(folder, number));
    }
    figure_3_6(models[7], out);
    figures_4_1_and_4_2({models[0], models[5], models[7], models[9]}, out);
    figure_4_3({models[2], models[6], models[7], models[9]}, out);
    Picture all(5);
    for (const Model& model : models) all.add(model, model.skeleton.refined, model.name);
    all.write(out / "figure-4.4.svg");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << kUsage;
        return 2;
    }
    try {
        run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_skeleton_figures: " << error.what() << '\n';
        return 1;
    }
}
