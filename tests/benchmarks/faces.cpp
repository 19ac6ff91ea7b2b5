// Whether a model's parts and rig depend on how its faces lie: models of the Princeton segmentation
// benchmark, spread over all classes, as copies whose faces are turned over, come twice or have
// vertices of their own, against the parts and joints of the model itself.
//   ossuary_faces [MODELS [OUT.csv]]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/decomposition/decompose.h"
#include "engine/decomposition/rig.h"
#include "engine/decomposition/segmentation_metrics.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/random.h"

namespace {

using namespace ossuary;
using Random = std::mt19937_64;

constexpr int kJobs = 2;
constexpr double kJitter = 1e-7;     // of the bounding box' diagonal, along each axis
constexpr double kSameJoint = 0.03;  // of it, between the middles of two joints' bones

/// A changed model and what it is made of.
struct Copy {
    mesh::TriangleMesh mesh;
    std::vector<std::uint32_t> face_of;    ///< of each of its triangles, in the model
    std::vector<std::uint32_t> vertex_of;  ///< of each of its vertices, in the model
};

Copy unchanged(const mesh::TriangleMesh& mesh) {
    Copy copy{mesh, std::vector<std::uint32_t>(mesh.triangles.size()),
              std::vector<std::uint32_t>(mesh.vertices.size())};
    std::iota(copy.face_of.begin(), copy.face_of.end(), 0U);
    std::iota(copy.vertex_of.begin(), copy.vertex_of.end(), 0U);
    return copy;
}

/// Programs turn a face over by any two of its corners.
void turn(mesh::TriangleMesh::Triangle& triangle, Random& random) {
    const std::size_t first = test::next_below(random, 3);
    std::swap(triangle[first], triangle[(first + 1) % 3]);
}

void turn_all(Copy& copy, Random& random) {
    for (auto& triangle : copy.mesh.triangles) turn(triangle, random);
}

void turn_one_in_50(Copy& copy, Random& random) {
    for (auto& triangle : copy.mesh.triangles) {
        if (test::next_below(random, 50) == 0) turn(triangle, random);
    }
}

void turn_half(Copy& copy, Random& random) {
    for (auto& triangle : copy.mesh.triangles) {
        if (test::next_below(random, 2) == 0) turn(triangle, random);
    }
}

void repeat(Copy& copy, Random&) {
    const std::size_t count = copy.face_of.size();
    for (std::size_t t = 0; t < count; ++t) {
        copy.mesh.triangles.push_back(copy.mesh.triangles[t]);
        copy.face_of.push_back(copy.face_of[t]);
    }
}

void repeat_turned(Copy& copy, Random& random) {
    const std::size_t count = copy.face_of.size();
    repeat(copy, random);
    for (std::size_t t = count; t < 2 * count; ++t) turn(copy.mesh.triangles[t], random);
}

void own_vertices(Copy& copy, Random&) {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> vertex_of;
    for (auto& triangle : copy.mesh.triangles) {
        for (std::uint32_t& vertex : triangle) {
            vertices.push_back(copy.mesh.vertices[vertex]);
            vertex_of.push_back(copy.vertex_of[vertex]);
            vertex = static_cast<std::uint32_t>(vertices.size() - 1);
        }
    }
    copy.mesh.vertices = std::move(vertices);
    copy.vertex_of = std::move(vertex_of);
}

void jitter(Copy& copy, Random& random) {
    const double most = kJitter * mesh::measure(copy.mesh).diagonal;
    for (Vec3& vertex : copy.mesh.vertices) {
        for (double& x : vertex) x += most * (2.0 * test::next_unit(random) - 1.0);
    }
}

void jitter_seams(Copy& copy, Random& random) {
    own_vertices(copy, random);
    jitter(copy, random);
}

void all_at_once(Copy& copy, Random& random) {
    repeat_turned(copy, random);
    turn_half(copy, random);
    jitter_seams(copy, random);
}

struct Change {
    const char* name;
    void (*apply)(Copy&, Random&);
};
/// `moved` is no fault of faces: it shows what a difference of 1e-7 alone does.
constexpr std::array<Change, 9> kChanges = {{{"all turned", turn_all},
                                             {"one in 50 turned", turn_one_in_50},
                                             {"half turned", turn_half},
                                             {"each twice", repeat},
                                             {"each twice, back to back", repeat_turned},
                                             {"own vertices", own_vertices},
                                             {"own vertices, jittered", jitter_seams},
                                             {"all at once", all_at_once},
                                             {"moved by 1e-7", jitter}}};

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

/// The middle of the bone that each vertex of the input follows most.
std::vector<Vec3> bones_of_vertices(const decomposition::Decomposition& made) {
    const decomposition::Rig rig = decomposition::make_rig(made.surface.mesh, made.skeleton);
    std::vector<Vec3> middles;
    for (const std::uint32_t vertex : made.surface.vertex_of) {
        if (vertex == mesh::MendedSurface::kUnused) {
            middles.emplace_back(Vec3::Zero());
            continue;
        }
        const auto& joint = rig.joints[rig.weights[vertex].joints[0]];
        if (joint.branch < 0) {
            middles.push_back(joint.position);
            continue;
        }
        const auto& points = made.skeleton.branches[static_cast<std::size_t>(joint.branch)].points;
        middles.push_back(points[points.size() / 2]);
    }
    return middles;
}

struct Outcome {
    std::size_t parts = 0;
    double rand_index_error = 0.0;  ///< against the model's own parts, over the copy's faces
    double elsewhere = 0.0;         ///< share of vertices at another joint
    bool warned = false;            ///< of turned faces
};

Outcome compare(const decomposition::Decomposition& own, const std::vector<Vec3>& own_bones,
                const Copy& copy, double diagonal) {
    const auto made = unwrap(decomposition::decompose(copy.mesh));
    decomposition::Segmentation expected{{}, own.segmentation.parts};
    for (const std::uint32_t face : copy.face_of) {
        expected.labels.push_back(own.segmentation.labels[face]);
    }
    Outcome outcome;
    outcome.parts = made.segmentation.parts;
    const std::vector<double> areas(copy.face_of.size(), 1.0);
    outcome.rand_index_error =
        decomposition::segmentation_errors(expected, made.segmentation, areas).rand_index_error;
    const std::vector<Vec3> bones = bones_of_vertices(made);
    for (std::size_t v = 0; v < bones.size(); ++v) {
        const double away = (bones[v] - own_bones[copy.vertex_of[v]]).norm();
        outcome.elsewhere += away > kSameJoint * diagonal ? 1.0 : 0.0;
    }
    outcome.elsewhere /= static_cast<double>(bones.size());
    outcome.warned = std::any_of(made.warnings.begin(), made.warnings.end(),
                                 [](const auto& w) { return w.code == "turned_faces"; });
    return outcome;
}

struct Row {
    ranking::ClassifiedModel model;
    std::string fault;  ///< why there are no outcomes
    std::size_t faces = 0;
    std::size_t parts = 0;
    std::array<Outcome, kChanges.size()> outcomes;
};

Row measure_model(const std::filesystem::path& off, const ranking::ClassifiedModel& model,
                  std::size_t number) {
    const auto read = unwrap(mesh::read_mesh(off / (model.id + ".off")));
    const auto own = unwrap(decomposition::decompose(read.mesh));
    const std::vector<Vec3> own_bones = bones_of_vertices(own);
    const double diagonal = mesh::measure(read.mesh).diagonal;
    Row row{model, {}, read.mesh.triangles.size(), own.segmentation.parts, {}};
    for (std::size_t c = 0; c < kChanges.size(); ++c) {
        Random random(1000 * number + c);
        Copy copy = unchanged(read.mesh);
        kChanges[c].apply(copy, random);
        row.outcomes[c] = compare(own, own_bones, copy, diagonal);
    }
    return row;
}

/// As many of each class as go, in the order of the classes.
std::vector<ranking::ClassifiedModel> chosen(const ranking::Classification& classes,
                                             std::size_t count) {
    std::vector<ranking::ClassifiedModel> all = ranking::models_in_order(classes);
    std::vector<ranking::ClassifiedModel> models;
    count = std::min(count, all.size());
    for (std::size_t i = 0; i < count; ++i) models.push_back(all[i * all.size() / count]);
    return models;
}

void print(const std::vector<Row>& rows) {
    std::cout << fmt::format("{} models\n{:<26}{:>9}{:>9}{:>9}{:>10}{:>10}{:>8}\n", rows.size(), "",
                             "mean", "largest", "> .02", "vertices", "largest", "warned");
    for (std::size_t c = 0; c < kChanges.size(); ++c) {
        double sum = 0.0, largest = 0.0, elsewhere = 0.0, most = 0.0;
        std::size_t above = 0, warned = 0;
        for (const Row& row : rows) {
            const Outcome& outcome = row.outcomes[c];
            sum += outcome.rand_index_error;
            largest = std::max(largest, outcome.rand_index_error);
            above += outcome.rand_index_error > 0.02 ? 1 : 0;
            elsewhere += outcome.elsewhere;
            most = std::max(most, outcome.elsewhere);
            warned += outcome.warned ? 1 : 0;
        }
        const auto count = static_cast<double>(rows.size());
        std::cout << fmt::format("{:<26}{:>9.5f}{:>9.5f}{:>9}{:>10.5f}{:>10.5f}{:>8}\n",
                                 kChanges[c].name, sum / count, largest, above, elsewhere / count,
                                 most, warned);
    }
}

void write(const std::vector<Row>& rows, const std::string& path) {
    std::ofstream csv(path);
    csv << "model,class,faces,copy,own_parts,parts,rand_index_error,vertices_elsewhere,warned\n";
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < kChanges.size(); ++c) {
            const Outcome& outcome = row.outcomes[c];
            csv << fmt::format("{},{},{},\"{}\",{},{},{:.6f},{:.6f},{}\n", row.model.id,
                               row.model.class_name, row.faces, kChanges[c].name, row.parts,
                               outcome.parts, outcome.rand_index_error, outcome.elsewhere,
                               outcome.warned ? 1 : 0);
        }
    }
    csv.close();
    if (!csv) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    const int count = argc > 1 ? std::atoi(argv[1]) : 76;
    if (!data || count < 1 || argc > 3) {
        std::cerr << "usage: ossuary_faces [MODELS [OUT.csv]], with OSSUARY_DATA set to the folder "
                     "of princeton-segmentation/\n";
        return 2;
    }
    const auto collection = *data / "princeton-segmentation";
    try {
        const auto classes =
            unwrap(ranking::read_classification(collection / "segmentation-all.cla"));
        const auto models = chosen(classes, static_cast<std::size_t>(count));
        std::vector<Row> rows(models.size());
        parallel_for(models.size(), kJobs, [&](std::size_t i) {
            try {
                rows[i] = measure_model(collection / "off", models[i], i);
            } catch (const std::exception& error) {
                rows[i].fault = models[i].id + ": " + error.what();
            }
        });
        for (const Row& row : rows) {
            if (!row.fault.empty()) throw std::runtime_error(row.fault);
        }
        print(rows);
        if (argc > 2) write(rows, argv[2]);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_faces: " << error.what() << '\n';
        return 1;
    }
}
