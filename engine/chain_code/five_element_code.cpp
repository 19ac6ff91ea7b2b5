#include "engine/chain_code/five_element_code.h"

#include <cassert>

namespace ossuary::chain_code {

char chain_element(const Vec3i& b, const Vec3i& c, const Vec3i& d) {
    assert(c.cwiseAbs().sum() == 1 && d.cwiseAbs().sum() == 1 && d != -c);
    if (d == c) return '0';
    // Before the first turn the path has no b; the highest value agrees with the rule by which
    // orthogonalize chooses.
    if (b.isZero()) return '4';
    if (d == b) return '2';
    if (d == -b) return '4';
    const Vec3i across = b.cross(c);
    assert(d == across || d == -across);
    return d == across ? '1' : '3';
}

std::string five_element_code(std::span<const Vec3i> path) {
    std::string code;
    if (path.size() < 3) return code;
    code.reserve(path.size() - 2);
    Vec3i b = Vec3i::Zero();
    Vec3i c = path[1] - path[0];
    for (std::size_t i = 2; i < path.size(); ++i) {
        const Vec3i d = path[i] - path[i - 1];
        code.push_back(chain_element(b, c, d));
        if (d != c) {
            b = c;
            c = d;
        }
    }
    return code;
}

Result<std::vector<Vec3i>> decode_five_element_code(std::string_view code) {
    std::vector<Vec3i> path = {Vec3i::Zero(), Vec3i::UnitX()};
    Vec3i b = Vec3i::UnitY();
    Vec3i c = Vec3i::UnitX();
    for (std::size_t i = 0; i < code.size(); ++i) {
        Vec3i d;
        switch (code[i]) {
            case '0':
                d = c;
                break;
            case '1':
                d = b.cross(c);
                break;
            case '2':
                d = b;
                break;
            case '3':
                d = -b.cross(c);
                break;
            case '4':
                d = -b;
                break;
            default:
                return {ErrorCode::kInvalidArgument,
                        "chain code: found '" + std::string(1, code[i]) + "' at position " +
                            std::to_string(i) + ", expected '0' to '4'"};
        }
        path.push_back(path.back() + d);
        if (d != c) {
            b = c;
            c = d;
        }
    }
    return path;
}

}  // namespace ossuary::chain_code
