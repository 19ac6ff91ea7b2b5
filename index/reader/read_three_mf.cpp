#include "index/reader/read_three_mf.h"

#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "index/reader/beam_lattice.h"
#include "index/reader/scene_builder.h"
#include "index/reader/three_mf_colours.h"
#include "index/reader/three_mf_extensions.h"
#include "index/reader/three_mf_package.h"

namespace ossuary::index {
namespace {

using three_mf::Instance;
using three_mf::made_by;
using Matrix4 = Eigen::Matrix4d;

using Handle = NMR::PLib3MFBase;

Error invalid(const std::string& found) {
    return {ErrorCode::kThreeMfInvalid, "expected a 3MF package, found " + found};
}

Error library_error(Handle* instance, const char* doing) {
    DWORD code = 0;
    LPCSTR text = nullptr;
    if (NMR::lib3mf_getlasterror(instance, &code, &text) != LIB3MF_OK || text == nullptr) {
        return invalid(std::string("one that cannot be used (") + doing + ")");
    }
    return invalid("an error (" + std::string(doing) + "): " + text);
}

/// Rows of the file's matrix are the images of the axes and the origin.
Matrix4 matrix_of(const NMR::MODELTRANSFORM& transform) {
    Matrix4 matrix = Matrix4::Identity();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix(row, column) = double{transform.m_fFields[row][column]};
        }
    }
    return matrix;
}

double metres_of(DWORD unit) {
    constexpr std::array kMetres = {1e-6, 1e-3, 1e-2, 0.0254, 0.3048, 1.0};
    return unit < kMetres.size() ? kMetres[unit] : kMetres[NMR::MODELUNIT_MILLIMETER];
}

class ThreeMfReader {
public:
    explicit ThreeMfReader(const mesh::ReadMeshOptions& caps)
        : caps_(caps), scene_(caps, SceneBuilder::Corners::kKeep) {}

    Result<mesh::ReadMeshResult> read(std::string_view bytes);

private:
    Result<void> open(std::string_view bytes);
    Result<void> open_package(std::string_view bytes);
    Result<void> hear_warnings(Handle* reader);
    Result<void> add_items();
    Result<void> add_item(Handle* item);
    Result<void> add_object(Handle* object, const Matrix4& matrix, int depth);
    Result<void> add_components(Handle* object, const Matrix4& matrix, int depth);
    Result<void> add_mesh(Handle* object, const Matrix4& matrix);
    Result<void> add_beams(Handle* object, const Matrix4& matrix);
    Result<void> add_placed(std::span<const Vec3> vertices,
                            std::span<const mesh::TriangleMesh::Triangle> triangles,
                            const ThreeMfColours& colours, const Matrix4& matrix);

    const mesh::ReadMeshOptions& caps_;
    SceneBuilder scene_;
    std::string trimmed_;  ///< the package, where it is not the file's
    Instance model_;
    std::size_t unclipped_ = 0;           ///< beams
    std::vector<Vec3> vertices_;          ///< of a mesh
    std::vector<std::uint32_t> numbers_;  ///< in the scene, of the vertices that are placed
};

Result<void> ThreeMfReader::open(std::string_view bytes) {
    Result<void> opened = open_package(bytes);
    if (opened || opened.error().code != ErrorCode::kThreeMfInvalid) return opened;
    // What lies beside the model is no reason to refuse it.
    auto trimmed = trim_package(bytes);
    if (!trimmed) return opened;
    trimmed_ = std::move(trimmed->bytes);
    if (!open_package(trimmed_)) return opened;
    scene_.warn("relations_skipped", trimmed->dropped,
                mesh::plural(trimmed->dropped, "relation") + " to what is not the model");
    return {};
}

Result<void> ThreeMfReader::open_package(std::string_view bytes) {
    model_ = made_by([](auto** made) { return NMR::lib3mf_createmodel(made); });
    if (!model_) return {ErrorCode::kReaderMemory, "expected memory for a model, found none"};
    const Instance reader = made_by(
        [&](auto** made) { return NMR::lib3mf_model_queryreader(model_.get(), "3mf", made); });
    if (!reader) return {ErrorCode::kInternal, "expected a reader of 3MF in lib3mf, found none"};
    auto* data = reinterpret_cast<BYTE*>(const_cast<char*>(bytes.data()));
    if (NMR::lib3mf_reader_readfrombuffer(reader.get(), data, bytes.size()) != LIB3MF_OK) {
        return library_error(reader.get(), "reading");
    }
    return hear_warnings(reader.get());
}

/// lib3mf goes on where it can. Where that leaves numbers or corners out, the surface would be
/// another one than was meant.
Result<void> ThreeMfReader::hear_warnings(Handle* reader) {
    constexpr std::array<DWORD, 5> kOfTheSurface = {
        NMR_ERROR_MODELCOORDINATEMISSING, NMR_ERROR_INVALIDMODELCOORDINATES,
        NMR_ERROR_INVALIDMODELCOORDINATEINDICES, NMR_ERROR_INVALIDMODELNODEINDEX,
        NMR_ERROR_INVALIDCOORDINATES};
    DWORD warnings = 0;
    NMR::lib3mf_reader_getwarningcount(reader, &warnings);
    std::string first;
    for (DWORD i = 0; i < warnings; ++i) {
        std::array<char, 512> text{};
        DWORD code = 0;
        ULONG needed = 0;
        NMR::lib3mf_reader_getwarningutf8(reader, i, &code, text.data(),
                                          static_cast<ULONG>(text.size() - 1), &needed);
        const bool spoils_surface =
            std::find(kOfTheSurface.begin(), kOfTheSurface.end(), code) != kOfTheSurface.end();
        if (spoils_surface) return invalid(std::string("a fault: ") + text.data());
        if (i == 0) first = text.data();
    }
    scene_.warn("reader_notes", warnings, "lib3mf says of the file: " + first);
    return {};
}

Result<void> ThreeMfReader::add_placed(std::span<const Vec3> vertices,
                                       std::span<const mesh::TriangleMesh::Triangle> triangles,
                                       const ThreeMfColours& colours, const Matrix4& matrix) {
    numbers_.clear();
    for (const Vec3& vertex : vertices) {
        const Vec3 placed = matrix.topLeftCorner<3, 3>() * vertex + matrix.topRightCorner<3, 1>();
        const auto number = scene_.add_vertex(placed);
        if (!number) return number.error();
        numbers_.push_back(*number);
    }
    const bool mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0.0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const mesh::TriangleMesh::Triangle& triangle = triangles[t];
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (triangle[corner] >= vertices.size()) return invalid("a corner that is no vertex");
            corners[corner] = numbers_[triangle[corner]];
        }
        if (mirrored) std::swap(corners[1], corners[2]);
        if (auto added = scene_.add_face(corners); !added) return added;
        if (colours.empty() || !colours[t]) continue;
        const auto& [a, b, c] = *colours[t];
        scene_.colour_face(corners, std::array{a, mirrored ? c : b, mirrored ? b : c});
    }
    return {};
}

Result<void> ThreeMfReader::add_mesh(Handle* object, const Matrix4& matrix) {
    DWORD vertices = 0;
    DWORD triangles = 0;
    if (NMR::lib3mf_meshobject_getvertexcount(object, &vertices) != LIB3MF_OK ||
        NMR::lib3mf_meshobject_gettrianglecount(object, &triangles) != LIB3MF_OK) {
        return library_error(object, "counting");
    }
    std::vector<NMR::MODELMESHVERTEX> positions(vertices);
    std::vector<NMR::MODELMESHTRIANGLE> faces(triangles);
    if ((vertices > 0 && NMR::lib3mf_meshobject_getvertices(object, positions.data(), vertices,
                                                            nullptr) != LIB3MF_OK) ||
        (triangles > 0 && NMR::lib3mf_meshobject_gettriangleindices(object, faces.data(), triangles,
                                                                    nullptr) != LIB3MF_OK)) {
        return library_error(object, "taking a mesh");
    }
    vertices_.clear();
    for (const NMR::MODELMESHVERTEX& position : positions) {
        vertices_.emplace_back(double{position.m_fPosition[0]}, double{position.m_fPosition[1]},
                               double{position.m_fPosition[2]});
    }
    if (triangles > 0) {
        std::vector<mesh::TriangleMesh::Triangle> corners;
        corners.reserve(triangles);
        for (const NMR::MODELMESHTRIANGLE& face : faces) {
            corners.push_back({face.m_nIndices[0], face.m_nIndices[1], face.m_nIndices[2]});
        }
        const ThreeMfColours colours = three_mf_colours(model_.get(), object, triangles);
        if (auto added = add_placed(vertices_, corners, colours, matrix); !added) return added;
    }
    return add_beams(object, matrix);
}

BeamCap cap_of(NMR::eModelBeamLatticeCapMode mode) {
    switch (mode) {
        case NMR::MODELBEAMLATTICECAPMODE_HEMISPHERE:
            return BeamCap::kHemisphere;
        case NMR::MODELBEAMLATTICECAPMODE_BUTT:
            return BeamCap::kButt;
        default:
            return BeamCap::kSphere;
    }
}

/// The lattice of a mesh, between vertices_.
Result<void> ThreeMfReader::add_beams(Handle* object, const Matrix4& matrix) {
    DWORD count = 0;
    if (NMR::lib3mf_meshobject_getbeamcount(object, &count) != LIB3MF_OK || count == 0) return {};
    std::vector<NMR::MODELMESHBEAM> stored(count);
    if (NMR::lib3mf_meshobject_getbeamindices(object, stored.data(), count, nullptr) != LIB3MF_OK) {
        return library_error(object, "taking beams");
    }
    std::vector<Beam> beams;
    beams.reserve(count);
    for (const NMR::MODELMESHBEAM& beam : stored) {
        beams.push_back({{beam.m_nIndices[0], beam.m_nIndices[1]},
                         {beam.m_dRadius[0], beam.m_dRadius[1]},
                         {cap_of(beam.m_eCapMode[0]), cap_of(beam.m_eCapMode[1])}});
    }
    auto mode = NMR::MODELBEAMLATTICECLIPMODE_NONE;
    DWORD clip = 0;
    if (NMR::lib3mf_meshobject_getbeamlattice_clipping(object, &mode, &clip) == LIB3MF_OK &&
        mode != NMR::MODELBEAMLATTICECLIPMODE_NONE) {
        unclipped_ += count;
    }
    const auto surface = beam_lattice_surface(vertices_, beams, caps_);
    if (!surface) return surface.error();
    return add_placed(surface->vertices, surface->triangles, {}, matrix);
}

Result<void> ThreeMfReader::add_components(Handle* object, const Matrix4& matrix, int depth) {
    DWORD count = 0;
    if (NMR::lib3mf_componentsobject_getcomponentcount(object, &count) != LIB3MF_OK) {
        return library_error(object, "counting components");
    }
    for (DWORD i = 0; i < count; ++i) {
        const Instance component = made_by([&](auto** made) {
            return NMR::lib3mf_componentsobject_getcomponent(object, i, made);
        });
        if (!component) return library_error(object, "taking a component");
        const Instance part = made_by([&](auto** made) {
            return NMR::lib3mf_component_getobjectresource(component.get(), made);
        });
        NMR::MODELTRANSFORM transform{};
        if (!part || NMR::lib3mf_component_gettransform(component.get(), &transform) != LIB3MF_OK) {
            return library_error(component.get(), "taking a component's object");
        }
        if (auto added = add_object(part.get(), matrix * matrix_of(transform), depth + 1); !added) {
            return added;
        }
    }
    return {};
}

Result<void> ThreeMfReader::add_object(Handle* object, const Matrix4& matrix, int depth) {
    constexpr int kDeepest = 200;
    if (depth > kDeepest) return invalid("components nested more than 200 deep");
    BOOL is_mesh = 0;
    if (NMR::lib3mf_object_ismeshobject(object, &is_mesh) != LIB3MF_OK) {
        return library_error(object, "taking an object");
    }
    return is_mesh != 0 ? add_mesh(object, matrix) : add_components(object, matrix, depth);
}

/// A text of an object or an item; empty where there is none.
template <typename Call>
std::string text_by(Handle* instance, Call call) {
    ULONG needed = 0;
    if (call(instance, nullptr, 0, &needed) != LIB3MF_OK || needed == 0) return {};
    std::string text(needed + 1, '\0');
    if (call(instance, text.data(), static_cast<ULONG>(text.size()), &needed) != LIB3MF_OK) {
        return {};
    }
    text.resize(std::min<std::size_t>(needed, text.size()));
    while (!text.empty() && text.back() == '\0') text.pop_back();
    return text;
}

Result<void> ThreeMfReader::add_item(Handle* item) {
    const Instance object =
        made_by([&](auto** made) { return NMR::lib3mf_builditem_getobjectresource(item, made); });
    if (!object) return library_error(item, "taking an item's object");
    Matrix4 matrix = Matrix4::Identity();
    BOOL placed = 0;
    NMR::MODELTRANSFORM transform{};
    if (NMR::lib3mf_builditem_hasobjecttransform(item, &placed) == LIB3MF_OK && placed != 0 &&
        NMR::lib3mf_builditem_getobjecttransform(item, &transform) == LIB3MF_OK) {
        matrix = matrix_of(transform);
    }
    std::string name = text_by(object.get(), NMR::lib3mf_object_getnameutf8);
    if (name.empty()) name = text_by(item, NMR::lib3mf_builditem_getpartnumberutf8);
    scene_.begin_object(std::move(name));
    if (auto added = add_object(object.get(), matrix, 0); !added) return added;
    scene_.end_object();
    return {};
}

Result<void> ThreeMfReader::add_items() {
    const Instance items =
        made_by([&](auto** made) { return NMR::lib3mf_model_getbuilditems(model_.get(), made); });
    if (!items) return library_error(model_.get(), "taking the build");
    BOOL more = 0;
    while (NMR::lib3mf_builditemiterator_movenext(items.get(), &more) == LIB3MF_OK && more != 0) {
        const Instance item = made_by([&](auto** made) {
            return NMR::lib3mf_builditemiterator_getcurrent(items.get(), made);
        });
        if (!item) return library_error(items.get(), "taking an item");
        if (auto added = add_item(item.get()); !added) return added;
    }
    return {};
}

Result<mesh::ReadMeshResult> ThreeMfReader::read(std::string_view bytes) {
    if (auto opened = open(bytes); !opened) return opened.error();
    if (auto added = add_items(); !added) return added.error();
    scene_.warn("beams_not_clipped", unclipped_,
                mesh::plural(unclipped_, "beam") + " of lattices that a mesh was to cut off");
    mesh::ReadMeshResult read = scene_.take();
    DWORD unit = NMR::MODELUNIT_MILLIMETER;
    NMR::lib3mf_model_getunit(model_.get(), &unit);
    read.metres_per_unit = metres_of(unit);
    read.up = mesh::UpAxis::kZ;
    return read;
}

}  // namespace

Result<mesh::ReadMeshResult> read_three_mf(std::string_view bytes,
                                           const mesh::ReadMeshOptions& caps) {
    if (auto known = check_required_extensions(bytes); !known) return known.error();
    return ThreeMfReader(caps).read(bytes);
}

}  // namespace ossuary::index
