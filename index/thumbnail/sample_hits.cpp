#include "index/thumbnail/sample_hits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ossuary::index {
namespace {

constexpr std::uint32_t kNotLookedAt = 0xFFFFFFFFu;

/// Twice the area between an edge and a point, the same but for its sign whichever way the edge
/// runs. Coordinates are floats, whose differences and products are exact in doubles or nearly so:
/// the sign is right.
class Edge {
public:
    Edge(const Vec3f& a, const Vec3f& b) {
        const bool turned = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
        const Vec3f& from = turned ? b : a;
        const Vec3f& to = turned ? a : b;
        x_ = double{from.x()};
        y_ = double{from.y()};
        sign_ = turned ? -1.0 : 1.0;
        dx_ = double{to.x()} - x_;
        dy_ = double{to.y()} - y_;
    }
    void turn_over() { sign_ = -sign_; }
    void begin_row(double y) { of_row_ = dx_ * (y - y_); }
    [[nodiscard]] double at(double x) const { return sign_ * (of_row_ - dy_ * (x - x_)); }

private:
    double x_ = 0.0, y_ = 0.0, dx_ = 0.0, dy_ = 0.0, sign_ = 1.0, of_row_ = 0.0;
};

class Rasterizer {
public:
    explicit Rasterizer(const SampleGrid& grid) : size_(grid.size), side_(grid.side) {
        const auto pixels = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
        first_.resize(pixels, kNotLookedAt);
        std::uint32_t next = 0;
        for (std::size_t p = 0; p < pixels; ++p) {
            if (!grid.mask.empty() && grid.mask[p] == 0) continue;
            first_[p] = next;
            next += static_cast<std::uint32_t>(side_ * side_);
        }
        for (int i = 0; i < size_ * side_; ++i) lines_.push_back((i + 0.5) / side_);
        hits_.resize(next);
        depths_.assign(next, -std::numeric_limits<float>::infinity());
    }

    void draw(std::uint32_t triangle, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        const auto [left, right] =
            lines_between(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}));
        const auto [top, bottom] =
            lines_between(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}));
        if (left > right || top > bottom) return;
        Edge ab(a, b), bc(b, c), ca(c, a);
        ab.begin_row(double{c.y()});
        const double area = ab.at(double{c.x()});
        if (area == 0.0) return;  // edge-on
        if (area < 0.0) {
            for (Edge* edge : {&ab, &bc, &ca}) edge->turn_over();
        }
        const double scale = 1.0 / std::abs(area);
        for (int i = top; i <= bottom; ++i) {
            const double y = lines_[static_cast<std::size_t>(i)];
            for (Edge* edge : {&ab, &bc, &ca}) edge->begin_row(y);
            const std::uint32_t* const pixels =
                first_.data() + static_cast<std::size_t>(i / side_) * std::size_t(size_);
            const int down = i % side_ * side_;
            int column = left / side_, beside = left % side_;
            for (int j = left; j <= right; ++j) {
                const std::uint32_t first = pixels[column];
                const auto sample = static_cast<std::size_t>(first) + std::size_t(down + beside);
                if (++beside == side_) {
                    beside = 0;
                    ++column;
                }
                if (first == kNotLookedAt) continue;
                const double x = lines_[static_cast<std::size_t>(j)];
                const double of_b = ca.at(x), of_c = ab.at(x);
                if (of_b < 0.0 || of_c < 0.0 || bc.at(x) < 0.0) continue;
                const auto u = static_cast<float>(scale * of_b);
                const auto v = static_cast<float>(scale * of_c);
                const float depth = a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z());
                if (depth <= depths_[sample]) continue;
                depths_[sample] = depth;
                hits_[sample] = {triangle, u, v};
            }
        }
    }

    std::vector<SampleHit> take() { return std::move(hits_); }

private:
    /// The first and the last line of samples from `low` to `high`.
    [[nodiscard]] std::pair<int, int> lines_between(float low, float high) const {
        const auto line = [this](double at) {
            return static_cast<int>(std::clamp(at, -1.0, static_cast<double>(size_ * side_)));
        };
        const double first = std::ceil(double{low} * side_ - 0.5);
        const double last = std::floor(double{high} * side_ - 0.5);
        return {std::max(line(first), 0), std::min(line(last), size_ * side_ - 1)};
    }

    int size_;
    int side_;
    std::vector<std::uint32_t> first_;  ///< of each pixel's samples
    std::vector<double> lines_;         ///< of samples, from the left or from the top
    std::vector<SampleHit> hits_;
    std::vector<float> depths_;
};

}  // namespace

std::vector<SampleHit> find_sample_hits(std::span<const Vec3f> vertices,
                                        std::span<const std::array<std::uint32_t, 3>> triangles,
                                        const SampleGrid& grid, const std::stop_token& stop) {
    constexpr std::uint32_t kBetweenLooks = 0xFF;
    Rasterizer rasterizer(grid);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if ((t & kBetweenLooks) == 0 && stop.stop_requested()) break;
        const auto& [a, b, c] = triangles[t];
        rasterizer.draw(t, vertices[a], vertices[b], vertices[c]);
    }
    return rasterizer.take();
}

}  // namespace ossuary::index
