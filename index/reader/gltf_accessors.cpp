#include "index/reader/gltf_accessors.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace ossuary::index {
namespace {

Error invalid(const std::string& found) {
    return {ErrorCode::kGltfInvalid, "expected numbers of the model, found " + found};
}

std::string numbered(const char* what, int number) {
    return std::string(what) + " " + std::to_string(number);
}

std::size_t component_size(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

template <typename T>
T load(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));
    return value;
}

double load_component(const unsigned char* at, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return load<std::int8_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *at;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return load<std::int16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return load<std::uint32_t>(at);
        default:
            return double{load<float>(at)};
    }
}

/// As glTF defines normalised numbers: signed ones end at -1.
double normalised(double value, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return std::max(value / 127.0, -1.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return value / 255.0;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return std::max(value / 32767.0, -1.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return value / 65535.0;
        default:
            return value;
    }
}

/// A member of an extension as a number that is not negative; `missing` where there is none.
std::size_t member(const tinygltf::Value& object, const char* name, std::size_t missing) {
    if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsNumber()) return missing;
    const double value = object.Get(name).GetNumberAsDouble();
    constexpr double kMost = 4e9;
    return value >= 0.0 && value <= kMost ? static_cast<std::size_t>(value) : missing;
}

std::string word(const tinygltf::Value& object, const char* name) {
    if (!object.Has(name) || !object.Get(name).IsString()) return {};
    return object.Get(name).Get<std::string>();
}

/// One decoder of meshoptimizer's, by the extension's name for it. False for data that is damaged.
bool decode_meshopt(std::span<const unsigned char> data, const std::string& mode, std::size_t count,
                    std::size_t stride, std::vector<unsigned char>& out) {
    if (mode == "ATTRIBUTES") {
        return stride % 4 == 0 && stride > 0 && stride <= 256 &&
               meshopt_decodeVertexBuffer(out.data(), count, stride, data.data(), data.size()) == 0;
    }
    if (stride != 2 && stride != 4) return false;
    if (mode == "TRIANGLES") {
        return count % 3 == 0 &&
               meshopt_decodeIndexBuffer(out.data(), count, stride, data.data(), data.size()) == 0;
    }
    return mode == "INDICES" &&
           meshopt_decodeIndexSequence(out.data(), count, stride, data.data(), data.size()) == 0;
}

bool filter_meshopt(const std::string& filter, std::size_t count, std::size_t stride,
                    std::vector<unsigned char>& out) {
    if (filter.empty() || filter == "NONE") return true;
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
        meshopt_decodeFilterOct(out.data(), count, stride);
        return true;
    }
    if (filter == "QUATERNION" && stride == 8) {
        meshopt_decodeFilterQuat(out.data(), count, stride);
        return true;
    }
    if (filter == "EXPONENTIAL" && stride % 4 == 0) {
        meshopt_decodeFilterExp(out.data(), count, stride);
        return true;
    }
    return false;
}

}  // namespace

/// Where the elements of an accessor are: each `stride` bytes from the last.
struct GltfAccessors::Layout {
    std::span<const unsigned char> bytes;
    std::size_t stride = 0;
};

Result<std::span<const unsigned char>> GltfAccessors::slice(int buffer, std::size_t offset,
                                                            std::size_t length) {
    if (buffer < 0 || static_cast<std::size_t>(buffer) >= model_.buffers.size()) {
        return invalid("a view of " + numbered("buffer", buffer) + ", which there is not");
    }
    const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(buffer)].data;
    if (offset > data.size() || length > data.size() - offset) {
        return invalid("a view beyond the end of " + numbered("buffer", buffer));
    }
    return std::span<const unsigned char>(data).subspan(offset, length);
}

Result<std::span<const unsigned char>> GltfAccessors::decode(int number,
                                                             const tinygltf::Value& compression) {
    constexpr std::size_t kNone = ~std::size_t{0};
    const std::size_t buffer = member(compression, "buffer", kNone);
    const std::size_t count = member(compression, "count", kNone);
    const std::size_t stride = member(compression, "byteStride", kNone);
    const Error damaged = invalid("damaged compression in " + numbered("view", number));
    constexpr std::size_t kMostBytes = std::size_t{1} << 30;
    if (buffer >= model_.buffers.size() || stride == 0 || stride > 256 ||
        count > kMostBytes / stride) {
        return damaged;
    }
    const auto data = slice(static_cast<int>(buffer), member(compression, "byteOffset", 0),
                            member(compression, "byteLength", kNone));
    if (!data) return data.error();
    std::vector<unsigned char> out(count * stride);
    if (!decode_meshopt(*data, word(compression, "mode"), count, stride, out) ||
        !filter_meshopt(word(compression, "filter"), count, stride, out)) {
        return damaged;
    }
    const std::vector<unsigned char>& kept = decoded_[number] = std::move(out);
    return std::span<const unsigned char>(kept);
}

Result<std::span<const unsigned char>> GltfAccessors::view(int number) {
    if (number < 0 || static_cast<std::size_t>(number) >= model_.bufferViews.size()) {
        return invalid(numbered("view", number) + ", which there is not");
    }
    if (const auto done = decoded_.find(number); done != decoded_.end()) {
        return std::span<const unsigned char>(done->second);
    }
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(number)];
    const auto compression = view.extensions.find("EXT_meshopt_compression");
    if (compression != view.extensions.end()) return decode(number, compression->second);
    return slice(view.buffer, view.byteOffset, view.byteLength);
}

Result<const tinygltf::Accessor*> GltfAccessors::find(int number) {
    if (number < 0 || static_cast<std::size_t>(number) >= model_.accessors.size()) {
        return invalid(numbered("accessor", number) + ", which there is not");
    }
    return &model_.accessors[static_cast<std::size_t>(number)];
}

Result<GltfAccessors::Layout> GltfAccessors::layout_of(const tinygltf::Accessor& accessor) {
    const auto bytes = view(accessor.bufferView);
    if (!bytes) return bytes.error();
    const std::size_t element =
        component_size(accessor.componentType) *
        static_cast<std::size_t>(std::max(
            tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)), 0));
    const std::size_t told =
        model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    const std::size_t stride = told == 0 ? element : told;
    const Error beyond =
        invalid("an accessor beyond the end of " + numbered("view", accessor.bufferView));
    if (element == 0 || stride < element || accessor.byteOffset > bytes->size()) return beyond;
    const std::size_t room = bytes->size() - accessor.byteOffset;
    if (accessor.count > 0 &&
        (room < element || (accessor.count - 1) > (room - element) / stride)) {
        return beyond;
    }
    return Layout{bytes->subspan(accessor.byteOffset), stride};
}

Result<void> GltfAccessors::apply_sparse(const tinygltf::Accessor& accessor, int components,
                                         std::vector<double>& values) {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
        return invalid("negative numbers in a sparse accessor");
    }
    tinygltf::Accessor places;
    places.bufferView = sparse.indices.bufferView;
    places.byteOffset = static_cast<std::size_t>(sparse.indices.byteOffset);
    places.componentType = sparse.indices.componentType;
    places.type = TINYGLTF_TYPE_SCALAR;
    places.count = static_cast<std::size_t>(sparse.count);
    tinygltf::Accessor replacements = accessor;
    replacements.bufferView = sparse.values.bufferView;
    replacements.byteOffset = static_cast<std::size_t>(sparse.values.byteOffset);
    replacements.count = places.count;
    replacements.sparse.isSparse = false;
    if (places.count > accessor.count) return invalid("a sparse accessor larger than its whole");
    const auto at = this->values(places, 1);
    if (!at) return at.error();
    const auto by = this->values(replacements, components);
    if (!by) return by.error();
    const auto width = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < at->size(); ++i) {
        const double place = (*at)[i];
        if (!(place >= 0.0 && place < static_cast<double>(accessor.count))) {
            return invalid("a sparse accessor that replaces what there is not");
        }
        std::copy_n(
            by->begin() + static_cast<std::ptrdiff_t>(i * width), width,
            values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(place) * width));
    }
    return {};
}

Result<std::vector<double>> GltfAccessors::values(const tinygltf::Accessor& accessor,
                                                  int components) {
    const auto width = static_cast<std::size_t>(components);
    std::vector<double> values;
    if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
        if (accessor.bufferView < 0) {
            values.assign(accessor.count * width, 0.0);
            return values;
        }
        const auto layout = layout_of(accessor);
        if (!layout) return layout.error();
        const std::size_t size = component_size(accessor.componentType);
        values.reserve(accessor.count * width);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            const unsigned char* element = layout->bytes.data() + i * layout->stride;
            for (std::size_t c = 0; c < width; ++c) {
                const double value = load_component(element + c * size, accessor.componentType);
                values.push_back(accessor.normalized ? normalised(value, accessor.componentType)
                                                     : value);
            }
        }
    } else {
        values.assign(accessor.count * width, 0.0);
    }
    if (accessor.sparse.isSparse) {
        if (auto applied = apply_sparse(accessor, components, values); !applied) {
            return applied.error();
        }
    }
    return values;
}

Result<std::vector<Vec3>> GltfAccessors::positions(int number) {
    const auto accessor = find(number);
    if (!accessor) return accessor.error();
    if ((*accessor)->type != TINYGLTF_TYPE_VEC3) {
        return invalid(numbered("accessor", number) + ", which holds no positions");
    }
    if ((*accessor)->count > caps_.max_vertices) {
        return {ErrorCode::kModelTooManyVertices,
                "expected at most " + std::to_string(caps_.max_vertices) + " vertices, found " +
                    std::to_string((*accessor)->count)};
    }
    const auto numbers = values(**accessor, 3);
    if (!numbers) return numbers.error();
    std::vector<Vec3> positions(numbers->size() / 3);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = Vec3((*numbers)[3 * i], (*numbers)[3 * i + 1], (*numbers)[3 * i + 2]);
    }
    return positions;
}

Result<std::vector<std::array<float, 3>>> GltfAccessors::colours(int number, std::size_t vertices) {
    const auto found = find(number);
    if (!found) return found.error();
    tinygltf::Accessor accessor = **found;
    const bool with_alpha = accessor.type == TINYGLTF_TYPE_VEC4;
    if ((accessor.type != TINYGLTF_TYPE_VEC3 && !with_alpha) || accessor.count != vertices) {
        return invalid(numbered("accessor", number) + ", which holds no colours of the vertices");
    }
    accessor.normalized = true;  // of floats this says nothing
    const std::size_t width = with_alpha ? 4 : 3;
    const auto numbers = values(accessor, static_cast<int>(width));
    if (!numbers) return numbers.error();
    std::vector<std::array<float, 3>> colours(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            colours[i][channel] = static_cast<float>((*numbers)[width * i + channel]);
        }
    }
    return colours;
}

Result<std::vector<std::uint32_t>> GltfAccessors::indices(int number) {
    const auto accessor = find(number);
    if (!accessor) return accessor.error();
    if ((*accessor)->type != TINYGLTF_TYPE_SCALAR ||
        (*accessor)->componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
        return invalid(numbered("accessor", number) + ", which holds no indices");
    }
    if ((*accessor)->count > 3 * std::size_t{caps_.max_triangles}) {
        return {ErrorCode::kModelTooManyFaces,
                "expected at most " + std::to_string(caps_.max_triangles) + " triangles, found " +
                    std::to_string((*accessor)->count / 3)};
    }
    const auto numbers = values(**accessor, 1);
    if (!numbers) return numbers.error();
    std::vector<std::uint32_t> indices;
    indices.reserve(numbers->size());
    for (const double value : *numbers) {
        if (!(value >= 0.0 && value <= 4294967295.0)) return invalid("a negative index");
        indices.push_back(static_cast<std::uint32_t>(value));
    }
    return indices;
}

}  // namespace ossuary::index
