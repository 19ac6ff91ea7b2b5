#include "engine/mesh/colour.h"

#include <algorithm>
#include <cmath>

namespace ossuary::mesh {

float linear_from_srgb(std::uint8_t byte) {
    const float s = static_cast<float>(byte) / 255.0f;
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    const float s = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(std::lround(255.0f * s));
}

void NumberColours::set(std::size_t number, const std::array<float, 3>& colour) {
    if (!std::all_of(colour.begin(), colour.end(), [](float x) { return std::isfinite(x); })) {
        return;
    }
    if (number >= colours_.size()) colours_.resize(number + 1, {kNone, kNone, kNone});
    for (std::size_t channel = 0; channel < 3; ++channel) {
        colours_[number][channel] = std::max(colour[channel], 0.0F);
        largest_ = std::max(largest_, colour[channel]);
    }
}

std::vector<Colour> NumberColours::take(std::size_t count) const {
    std::vector<Colour> taken;
    if (colours_.empty()) return taken;
    taken.assign(count, kPlainColour);
    const float scale = largest_ > 1.0F ? 1.0F : 255.0F;
    for (std::size_t i = 0; i < std::min(count, colours_.size()); ++i) {
        if (colours_[i][0] == kNone) continue;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float byte = std::min(scale * colours_[i][channel], 255.0F);
            taken[i][channel] = static_cast<std::uint8_t>(std::lround(byte));
        }
    }
    return taken;
}

}  // namespace ossuary::mesh
