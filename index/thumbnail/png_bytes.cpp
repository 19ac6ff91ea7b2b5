#include "index/thumbnail/png_bytes.h"

#include <png.h>

#include <cassert>
#include <string>

#include "index/thumbnail/palette.h"

namespace ossuary::index {

Result<std::vector<std::uint8_t>> png_bytes(std::span<const std::uint8_t> pixels, int width,
                                            int height, int channels) {
    assert(channels == 3 || channels == 4);
    assert(pixels.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    // 2 ms for a thumbnail, where the default effort takes 7 to 18 for a file 11 % smaller.
    image.flags = PNG_IMAGE_FLAG_FAST;
    // A byte a pixel where so few colours are enough: a thumbnail in a third of the bytes (7 kB, 20
    // before).
    const auto palette = channels == 4 ? reduce_colours(pixels) : std::nullopt;
    if (palette) {
        image.format = PNG_FORMAT_RGBA_COLORMAP;
        image.colormap_entries = static_cast<png_uint_32>(palette->colours.size());
        image.flags = 0;
    }
    const void* colours = palette ? palette->colours.data() : nullptr;
    const std::uint8_t* written = palette ? palette->pixels.data() : pixels.data();
    std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, written, 0, colours) == 0) {
        return {ErrorCode::kInternal, std::string("libpng failed: ") + image.message};
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace ossuary::index
