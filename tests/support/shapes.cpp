#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "tests/support/random.h"

namespace ossuary::test {
namespace {

constexpr int kMargin = 2;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - a - t * d).norm();
}

bool in_torus(const Vec3& p, double major, double minor) {
    return std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) <= minor;
}

Box3 box_around(const Vec3& half) { return {-half, half}; }

voxel::BitVolume filled_box(const Vec3i& size) {
    voxel::BitVolume volume(size + Vec3i::Constant(2 * kMargin));
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            for (int x = 0; x < size.x(); ++x) volume.set(Vec3i(x, y, z).array() + kMargin);
        }
    }
    return volume;
}

}  // namespace

voxel::BitVolume sample_volume(const Box3& bounds, const std::function<bool(const Vec3&)>& inside) {
    const Vec3 low = bounds.min().array().floor();
    const Vec3i extent = (bounds.max().array().ceil() - low.array()).cast<int>();
    voxel::BitVolume volume(extent + Vec3i::Constant(2 * kMargin));
    for (int z = 0; z < extent.z(); ++z) {
        for (int y = 0; y < extent.y(); ++y) {
            for (int x = 0; x < extent.x(); ++x) {
                const Vec3i voxel(x, y, z);
                if (inside(low + voxel.cast<double>() + Vec3::Constant(0.5))) {
                    volume.set(voxel.array() + kMargin);
                }
            }
        }
    }
    return volume;
}

VolumeShape ball(double radius) {
    return {"ball",
            sample_volume(box_around(Vec3::Constant(radius)),
                          [=](const Vec3& p) { return p.norm() <= radius; }),
            {1, 0, 0}};
}

VolumeShape bar(const Vec3i& size) { return {"bar", filled_box(size), {1, 0, 0}}; }
VolumeShape cube(int side) { return {"cube", filled_box(Vec3i::Constant(side)), {1, 0, 0}}; }
VolumeShape plate(const Vec3i& size) { return {"plate", filled_box(size), {1, 0, 0}}; }

VolumeShape torus(double major, double minor) {
    const double reach = major + minor;
    return {"torus",
            sample_volume(box_around({reach, reach, minor}),
                          [=](const Vec3& p) { return in_torus(p, major, minor); }),
            {1, 1, 0}};
}

VolumeShape double_torus(double major, double minor) {
    const double reach = major + minor;
    const Vec3 offset(major, 0, 0);
    return {"double_torus",
            sample_volume(box_around({reach + major, reach, minor}),
                          [=](const Vec3& p) {
                              return in_torus(p - offset, major, minor) ||
                                     in_torus(p + offset, major, minor);
                          }),
            {1, 2, 0}};
}

VolumeShape hollow_ball(double outer, double inner) {
    return {"hollow_ball",
            sample_volume(box_around(Vec3::Constant(outer)),
                          [=](const Vec3& p) { return p.norm() <= outer && p.norm() > inner; }),
            {1, 0, 1}};
}

std::vector<Capsule> tree_capsules(double scale) {
    std::vector<Capsule> capsules = {
        {{0, 0, 0}, {0, 0, 40}, 7},         {{0, 0, 4}, {26, 6, -16}, 5},
        {{0, 0, 4}, {-24, -8, -20}, 4.5},   {{0, 0, 38}, {28, 0, 54}, 4},
        {{0, 0, 38}, {-18, 14, 62}, 5},     {{16, 0, 47.2}, {20, 16, 60}, 3},
        {{-13, -4.3, -9}, {-30, 8, -4}, 3},
    };
    for (Capsule& c : capsules) {
        c.a *= scale;
        c.b *= scale;
        c.radius *= scale;
    }
    return capsules;
}

voxel::BitVolume capsule_volume(const std::vector<Capsule>& capsules) {
    Box3 bounds;
    for (const Capsule& c : capsules) {
        for (const Vec3& end : {c.a, c.b}) {
            bounds.extend(Vec3(end.array() - c.radius));
            bounds.extend(Vec3(end.array() + c.radius));
        }
    }
    return sample_volume(bounds, [&](const Vec3& p) {
        return std::any_of(capsules.begin(), capsules.end(), [&](const Capsule& c) {
            return distance_to_segment(p, c.a, c.b) <= c.radius;
        });
    });
}

VolumeShape capsule_tree(double scale) {
    return {"capsule_tree", capsule_volume(tree_capsules(scale)), {1, 0, 0}};
}

VolumeShape trefoil_knot(double scale, double tube) {
    const auto curve = [=](double t) -> Vec3 {
        return scale * Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                            -std::sin(3 * t));
    };
    const Vec3 half = scale * Vec3(3, 3, 1) + Vec3::Constant(tube);
    const int reach = static_cast<int>(std::ceil(tube)) + 1;
    const Vec3i center = half.array().ceil().cast<int>() + kMargin;
    voxel::BitVolume volume(2 * center);
    const int samples = static_cast<int>(scale * 60);
    for (int i = 0; i < samples; ++i) {
        const Vec3 p = curve(2 * std::numbers::pi * i / samples) + center.cast<double>();
        const Vec3i voxel = p.array().floor().cast<int>();
        for (int z = -reach; z <= reach; ++z) {
            for (int y = -reach; y <= reach; ++y) {
                for (int x = -reach; x <= reach; ++x) {
                    const Vec3i v = voxel + Vec3i(x, y, z);
                    if (volume.contains(v) &&
                        (v.cast<double>() + Vec3::Constant(0.5) - p).norm() <= tube) {
                        volume.set(v);
                    }
                }
            }
        }
    }
    return {"trefoil_knot", std::move(volume), {1, 1, 0}};
}

VolumeShape linked_tori(double major, double minor) {
    const double reach = major + minor;
    const Vec3 low(-reach, -reach, -reach);
    const Vec3 high(reach + major, reach, reach);
    return {"linked_tori",
            sample_volume({low, high},
                          [=](const Vec3& p) {
                              const Vec3 q(p.x() - major, p.z(), p.y());
                              return in_torus(p, major, minor) || in_torus(q, major, minor);
                          }),
            {2, 2, 0}};
}

std::vector<VolumeShape> volume_shapes() {
    return {ball(),         bar(),         cube(),         plate(),        torus(),
            double_torus(), hollow_ball(), capsule_tree(), trefoil_knot(), linked_tori()};
}

voxel::BitVolume random_volume(const Vec3i& size, double density, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    voxel::BitVolume volume(size);
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            for (int x = 0; x < size.x(); ++x) {
                if (next_unit(random) < density) volume.set(x, y, z);
            }
        }
    }
    return volume;
}

voxel::BitVolume permuted(const voxel::BitVolume& volume, const Vec3i& order) {
    const auto pick = [&](const Vec3i& v) { return Vec3i(v[order[0]], v[order[1]], v[order[2]]); };
    voxel::BitVolume result(pick(volume.size()));
    voxel::for_each_voxel(volume, [&](const Vec3i& v) { result.set(pick(v)); });
    return result;
}

voxel::BitVolume mirrored(const voxel::BitVolume& volume, int axis) {
    voxel::BitVolume result(volume.size());
    voxel::for_each_voxel(volume, [&](Vec3i v) {
        v[axis] = volume.size()[axis] - 1 - v[axis];
        result.set(v);
    });
    return result;
}

}  // namespace ossuary::test
