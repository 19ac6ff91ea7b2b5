#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/mesh/colour.h"
#include "engine/mesh/load_number.h"

namespace ossuary::mesh {

// A binary STL file: a header with anything in it, a count, and of each triangle a normal, three
// corners and two bytes that the format gives no meaning.
inline constexpr std::size_t kStlHeader = 80;
inline constexpr std::size_t kStlStart = kStlHeader + 4;
inline constexpr std::size_t kStlTriangle = 50;

/// The two bytes of a triangle.
/// @pre it is there
[[nodiscard]] inline std::uint16_t stl_attribute(std::string_view bytes, std::size_t triangle) {
    constexpr std::size_t kAttribute = 48;
    return load_number<std::uint16_t>(
        bytes.data() + kStlStart + kStlTriangle * triangle + kAttribute, std::endian::little);
}

/// The colours of the triangles of a binary STL file, five bits a channel, in either of the two
/// ways that programs write them. Where the header has `COLOR=` and four bytes (Magics), that is
/// the colour of the model, and bit 15 says of each triangle that it has no other; red are the
/// lowest bits. Else bit 15 says that a triangle has a colour (VisCAM, SolidView), and blue are the
/// lowest.
/// @param attributes  the bits of all triangles' attributes, or-ed
/// @return  one for each triangle, or none
[[nodiscard]] std::vector<Colour> stl_colours(std::string_view bytes, std::size_t triangles,
                                              std::uint32_t attributes);

}  // namespace ossuary::mesh
