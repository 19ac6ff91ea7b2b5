#include "engine/registration/feature_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ossuary::registration {
namespace {

constexpr double kAngle = 0.4;       ///< radians that two angles may differ by
constexpr double kScaleSlack = 1.5;  ///< between what radii and what points say of the scale
constexpr double kLeastApart = 0.2;  ///< two points of a pair, over the diagonal
constexpr double kTogether = 0.08;   ///< points that are brought together, over the diagonal
constexpr std::size_t kMostTried = 600;

struct PointMatch {
    std::uint32_t piece = 0, whole = 0;
    double scale = 1.0;  ///< as the radii say
    int distance = 0;    ///< squared, of the features
};

std::vector<PointMatch> matches_of(const LocalFeatures& piece, const LocalFeatures& whole,
                                   const FeatureCandidateOptions& options) {
    std::vector<PointMatch> matches;
    std::vector<PointMatch> of_point;
    for (std::uint32_t p = 0; p < piece.points.size(); ++p) {
        of_point.clear();
        for (std::size_t r = 0; r < piece.radii.size(); ++r) {
            const LocalFeature& feature = piece.at(p, r);
            for (std::size_t s = 0; s < whole.radii.size(); ++s) {
                const double scale = whole.radii[s] / piece.radii[r];
                if (options.kind.scale ? scale < options.least_scale || scale > options.most_scale
                                       : std::abs(std::log(scale)) > std::log(1.2)) {
                    continue;
                }
                PointMatch best{p, 0, scale, std::numeric_limits<int>::max()};
                for (std::uint32_t w = 0; w < whole.points.size(); ++w) {
                    const int distance = piece_distance(feature, whole.at(w, s));
                    if (distance < best.distance) {
                        best.distance = distance;
                        best.whole = w;
                    }
                }
                of_point.push_back(best);
            }
        }
        const std::size_t kept = std::min(options.matches, of_point.size());
        std::partial_sort(
            of_point.begin(), of_point.begin() + static_cast<std::ptrdiff_t>(kept), of_point.end(),
            [](const PointMatch& a, const PointMatch& b) { return a.distance < b.distance; });
        matches.insert(matches.end(), of_point.begin(),
                       of_point.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    return matches;
}

/// Whether two angles, told by their cosines, differ by less than kAngle.
bool angles_agree(double a, double b) {
    // Cosines differ no more than angles do, and arcs take their time.
    if (std::abs(a - b) > kAngle) return false;
    return std::abs(std::acos(std::clamp(a, -1.0, 1.0)) - std::acos(std::clamp(b, -1.0, 1.0))) <
           kAngle;
}

/// Whether two pairs of oriented points may be one motion's, and how large it then makes things.
bool agree(const LocalFeatures& piece, const LocalFeatures& whole, const PointMatch& a,
           const PointMatch& b, double diagonal, const FeatureCandidateOptions& options) {
    if (a.piece == b.piece || a.whole == b.whole) return false;
    const Vec3 from = piece.points[b.piece] - piece.points[a.piece];
    const Vec3 to = whole.points[b.whole] - whole.points[a.whole];
    const double apart = from.norm();
    if (apart < kLeastApart * diagonal || !(to.norm() > 0.0)) return false;
    const double scale = to.norm() / apart;
    for (const PointMatch* match : {&a, &b}) {
        const double slack = scale / match->scale;
        if (slack > kScaleSlack || slack < 1.0 / kScaleSlack) return false;
    }
    if (options.kind.scale && (scale < options.least_scale || scale > options.most_scale)) {
        return false;
    }
    const Vec3 u = from / apart;
    const Vec3 v = to.normalized();
    const Vec3& na = piece.normals[a.piece];
    const Vec3& nb = piece.normals[b.piece];
    const Vec3& ma = whole.normals[a.whole];
    const Vec3& mb = whole.normals[b.whole];
    return angles_agree(na.dot(u), ma.dot(v)) && angles_agree(nb.dot(u), mb.dot(v)) &&
           angles_agree(na.dot(nb), ma.dot(mb));
}

Similarity motion_of(const LocalFeatures& piece, const LocalFeatures& whole, const PointMatch& a,
                     const PointMatch& b, const MotionKind& kind) {
    const double apart = (piece.points[b.piece] - piece.points[a.piece]).norm();
    const double length = (whole.points[b.whole] - whole.points[a.whole]).norm();
    const std::array<Vec3, 4> from{piece.points[a.piece], piece.points[b.piece],
                                   piece.points[a.piece] + 0.5 * apart * piece.normals[a.piece],
                                   piece.points[b.piece] + 0.5 * apart * piece.normals[b.piece]};
    const std::array<Vec3, 4> to{whole.points[a.whole], whole.points[b.whole],
                                 whole.points[a.whole] + 0.5 * length * whole.normals[a.whole],
                                 whole.points[b.whole] + 0.5 * length * whole.normals[b.whole]};
    return fit_similarity(from, to, {.scale = kind.scale, .mirror = kind.mirror});
}

/// Points of the piece, of all of them, that some match brings where the motion does.
double votes_for(const Similarity& motion, const LocalFeatures& piece, const LocalFeatures& whole,
                 const std::vector<PointMatch>& matches, double diagonal) {
    const double together = kTogether * diagonal * motion.scale;
    std::size_t votes = 0;
    std::uint32_t last = static_cast<std::uint32_t>(piece.points.size());
    for (const PointMatch& match : matches) {
        if (match.piece == last) continue;
        const Vec3 way = motion.point(piece.points[match.piece]) - whole.points[match.whole];
        if (way.squaredNorm() > together * together) continue;
        if (motion.normal(piece.normals[match.piece]).dot(whole.normals[match.whole]) < 0.5) {
            continue;
        }
        last = match.piece;
        ++votes;
    }
    return static_cast<double>(votes) / static_cast<double>(piece.points.size());
}

bool nearly_equal(const Similarity& a, const Similarity& b, const LocalFeatures& piece,
                  double diagonal) {
    double most = 0.0;
    for (std::size_t i = 0; i < piece.points.size(); i += 1 + piece.points.size() / 8) {
        most = std::max(most, (a.point(piece.points[i]) - b.point(piece.points[i])).norm());
    }
    return most < 2.0 * kTogether * diagonal * std::max(a.scale, b.scale);
}

}  // namespace

std::vector<FeatureCandidate> feature_candidates(const LocalFeatures& piece,
                                                 const LocalFeatures& whole, double diagonal,
                                                 const FeatureCandidateOptions& options) {
    const std::vector<PointMatch> matches = matches_of(piece, whole, options);
    struct Two {
        std::uint32_t a, b;
        int distance;
    };
    std::vector<Two> agreeing;
    for (std::uint32_t a = 0; a < matches.size(); ++a) {
        for (std::uint32_t b = a + 1; b < matches.size(); ++b) {
            if (!agree(piece, whole, matches[a], matches[b], diagonal, options)) continue;
            agreeing.push_back({a, b, matches[a].distance + matches[b].distance});
        }
    }
    std::stable_sort(agreeing.begin(), agreeing.end(),
                     [](const Two& x, const Two& y) { return x.distance < y.distance; });
    if (agreeing.size() > kMostTried) agreeing.resize(kMostTried);
    std::vector<FeatureCandidate> tried;
    for (const Two& two : agreeing) {
        FeatureCandidate candidate;
        candidate.placement = motion_of(piece, whole, matches[two.a], matches[two.b], options.kind);
        candidate.votes = votes_for(candidate.placement, piece, whole, matches, diagonal);
        tried.push_back(candidate);
    }
    std::stable_sort(tried.begin(), tried.end(),
                     [](const auto& x, const auto& y) { return x.votes > y.votes; });
    std::vector<FeatureCandidate> best;
    for (const FeatureCandidate& candidate : tried) {
        if (best.size() == options.most) break;
        const bool known = std::any_of(best.begin(), best.end(), [&](const auto& other) {
            return nearly_equal(candidate.placement, other.placement, piece, diagonal);
        });
        if (!known) best.push_back(candidate);
    }
    return best;
}

}  // namespace ossuary::registration
