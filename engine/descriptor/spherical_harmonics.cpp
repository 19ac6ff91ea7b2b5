#include "engine/descriptor/spherical_harmonics.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace ossuary {
namespace {

constexpr int kRows = 32;     // of latitude
constexpr int kColumns = 64;  // of longitude
constexpr int kOrders = kHarmonicDegrees;
constexpr double kReach = 2.0;  // in mean distances of the surface from its centre

using Row = std::array<double, kRows>;

/// What does not depend on the model: directions, cosines and weighted Legendre functions.
struct HarmonicTables {
    std::array<std::array<Vec3f, kColumns>, kRows> direction;
    std::array<std::array<std::complex<double>, kOrders>, kColumns> wave;  // exp(-i m phi)
    /// Normalised associated Legendre functions times the quadrature weight, [l][m][row].
    std::array<std::array<Row, kOrders>, kHarmonicDegrees> legendre{};

    HarmonicTables() {
        for (int row = 0; row < kRows; ++row) {
            const double theta = std::numbers::pi * (row + 0.5) / kRows;
            for (int column = 0; column < kColumns; ++column) {
                const double phi = 2.0 * std::numbers::pi * (column + 0.5) / kColumns;
                direction[at(row)][at(column)] =
                    Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta))
                        .cast<float>();
                for (int m = 0; m < kOrders; ++m) {
                    wave[at(column)][at(m)] = std::polar(1.0, -phi * m);
                }
            }
            const double weight =
                std::sin(theta) * (std::numbers::pi / kRows) * (2.0 * std::numbers::pi / kColumns);
            fill_legendre(at(row), std::cos(theta), std::sin(theta), weight);
        }
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// Orthonormal functions by the three-term recurrence in l, stable for these degrees.
    void fill_legendre(std::size_t row, double cosine, double sine, double weight) {
        double diagonal = std::sqrt(0.25 / std::numbers::pi);
        for (int m = 0; m < kOrders; ++m) {
            if (m > 0) diagonal *= sine * std::sqrt((2.0 * m + 1.0) / (2.0 * m));
            double previous = 0.0, current = diagonal;
            for (int l = m; l < kHarmonicDegrees; ++l) {
                legendre[at(l)][at(m)][row] = weight * current;
                const double n = l + 1.0;
                const double a = std::sqrt((4.0 * n * n - 1.0) / (n * n - m * m));
                const double b = l == m ? 0.0
                                        : std::sqrt(((n - 1.0) * (n - 1.0) - m * m) /
                                                    (4.0 * (n - 1.0) * (n - 1.0) - 1.0));
                const double next = a * (cosine * current - b * previous);
                previous = current;
                current = next;
            }
        }
    }
};

/// For each order m and row of latitude the Fourier coefficient of the solid on one shell.
using ShellWaves = std::array<std::array<std::complex<double>, kRows>, kOrders>;

void shell_waves(const HarmonicTables& tables, const BitVolume& solid, const Vec3f& center,
                 float radius, ShellWaves& waves) {
    for (std::size_t row = 0; row < kRows; ++row) {
        std::array<std::complex<double>, kOrders> sums{};
        for (std::size_t column = 0; column < kColumns; ++column) {
            const Vec3f at = center + radius * tables.direction[row][column];
            if (!solid.test_or_false(at.array().floor().cast<int>().matrix())) continue;
            for (std::size_t m = 0; m < kOrders; ++m) sums[m] += tables.wave[column][m];
        }
        for (std::size_t m = 0; m < kOrders; ++m) waves[m][row] = sums[m];
    }
}

}  // namespace

std::vector<float> spherical_harmonics(const SolidSurface& surface, const BitVolume& solid) {
    static const HarmonicTables kTables;
    std::vector<float> values;
    values.reserve(kHarmonicShells * kHarmonicDegrees);

    Vec3 center = Vec3::Zero();
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        center += static_cast<double>(surface.areas[i]) * surface.points[i].cast<double>();
    }
    if (surface.total_area > 0.0) center /= surface.total_area;
    double mean_distance = 0.0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        mean_distance += static_cast<double>(surface.areas[i]) *
                         (surface.points[i].cast<double>() - center).norm();
    }
    if (surface.total_area > 0.0) mean_distance /= surface.total_area;

    ShellWaves waves;
    for (int shell = 0; shell < kHarmonicShells; ++shell) {
        const double share = (shell + 0.5) / kHarmonicShells;
        const double radius = share * kReach * mean_distance;
        shell_waves(kTables, solid, center.cast<float>(), static_cast<float>(radius), waves);
        for (std::size_t l = 0; l < kHarmonicDegrees; ++l) {
            double energy = 0.0;
            for (std::size_t m = 0; m <= l; ++m) {
                std::complex<double> sum = 0.0;
                for (std::size_t row = 0; row < kRows; ++row) {
                    sum += kTables.legendre[l][m][row] * waves[m][row];
                }
                energy += (m == 0 ? 1.0 : 2.0) * std::norm(sum);  // orders m and -m alike
            }
            values.push_back(static_cast<float>(share * std::sqrt(energy)));
        }
    }
    return values;
}

}  // namespace ossuary
