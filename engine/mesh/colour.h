#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ossuary::mesh {

/// Red, green and blue as screens take them: sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Of the corners of a triangle, between which they run evenly.
using CornerColours = std::array<Colour, 3>;

/// What a face has whose file gives colours to others and none to it (the Geomview manual, "OFF":
/// .666 of each).
inline constexpr Colour kPlainColour = {170, 170, 170};

/// Between what is written down and light: IEC 61966-2-1.
[[nodiscard]] float linear_from_srgb(std::uint8_t byte);
[[nodiscard]] std::uint8_t srgb_from_linear(float linear);

/// Colours that a file gives as numbers without saying what the largest is: 1, unless one of them
/// is larger; then 255.
class NumberColours {
public:
    [[nodiscard]] bool empty() const { return colours_.empty(); }
    /// The colour of the vertex or face of this number; those that are left out have none. Numbers
    /// that are not finite give none.
    void set(std::size_t number, const std::array<float, 3>& colour);
    /// The colours of so many; the plain one for those that have none. Empty where none has one.
    [[nodiscard]] std::vector<Colour> take(std::size_t count) const;

private:
    static constexpr float kNone = -1.0F;
    std::vector<std::array<float, 3>> colours_;
    float largest_ = 0.0F;
};

}  // namespace ossuary::mesh
