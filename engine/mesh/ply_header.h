#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::mesh {

enum class PlyType : std::uint8_t {
    kInt8,
    kUint8,
    kInt16,
    kUint16,
    kInt32,
    kUint32,
    kFloat32,
    kFloat64
};

/// Bytes of a number in a binary file.
[[nodiscard]] std::size_t size_of(PlyType type);

/// What a property is to the reader of meshes.
enum class PlyMeaning : std::uint8_t { kX, kY, kZ, kRed, kGreen, kBlue, kCorners, kOther };

struct PlyProperty {
    std::string name;
    PlyMeaning meaning = PlyMeaning::kOther;  ///< by its name
    PlyType type = PlyType::kFloat32;         ///< of each value
    bool is_list = false;
    PlyType count_type = PlyType::kUint8;  ///< of the number of values that a list begins with
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;  ///< in the order of their values
    std::size_t line = 0;                 ///< of the header, from 1
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

/// What a PLY file says of itself before its data.
struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::kText;
    std::vector<PlyElement> elements;  ///< in the order of the data
    std::size_t bytes = 0;             ///< up to the data
    std::size_t lines = 0;
};

/// Whether bytes begin with the line `ply`.
[[nodiscard]] bool looks_like_ply(std::string_view bytes);

/// Reads the header of a PLY file (Turk, The PLY Polygon File Format, 1994), whose lines end with
/// LF, CR LF or a lone CR: all as the first does, so that data may begin with one of these bytes.
/// Messages name the line, not the file. Errors: ply_header.
Result<PlyHeader> read_ply_header(std::string_view bytes);

}  // namespace ossuary::mesh
