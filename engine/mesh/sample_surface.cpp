#include "engine/mesh/sample_surface.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

/// Uniform in [0, 1) in steps of 2^-53; the standard's own distributions differ between libraries.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

}  // namespace

std::vector<SurfaceSample> sample_surface(const TriangleMesh& mesh,
                                          const SampleSurfaceOptions& options) {
    std::vector<double> area_up_to = triangle_areas(mesh);
    double total = 0.0;
    for (double& area : area_up_to) area = total += area;
    std::vector<SurfaceSample> samples;
    if (!(total > 0)) return samples;

    std::mt19937_64 random(options.seed);
    samples.reserve(options.count);
    for (std::size_t i = 0; i < options.count; ++i) {
        double u = uniform(random);
        if (options.stratified) {
            u = (static_cast<double>(i) + u) / static_cast<double>(options.count);
        }
        const double r1 = std::sqrt(uniform(random));
        const double r2 = uniform(random);
        // The first triangle whose running sum exceeds the target has area, so a normal too.
        auto found = std::upper_bound(area_up_to.begin(), area_up_to.end(), u * total);
        if (found == area_up_to.end()) {
            found = std::lower_bound(area_up_to.begin(), area_up_to.end(), total);
        }
        SurfaceSample sample;
        sample.triangle = static_cast<std::uint32_t>(found - area_up_to.begin());
        sample.barycentric = Vec3(1 - r1, r1 * (1 - r2), r1 * r2);
        const auto [a, b, c] = mesh.corners(sample.triangle);
        sample.point =
            sample.barycentric[0] * a + sample.barycentric[1] * b + sample.barycentric[2] * c;
        sample.normal =
            (b - a).stableNormalized().cross((c - a).stableNormalized()).stableNormalized();
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace ossuary::mesh
