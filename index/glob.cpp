#include "index/glob.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ossuary::index {
namespace {

/// One step of a pattern.
struct Step {
    enum class Kind { kOne, kSet, kAny, kManyInName, kManyFolders };
    Kind kind = Kind::kOne;
    std::string_view text;  ///< one: the character; set: what stands between [ and ]
};

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// The first character, whole where it is UTF-8, else its first byte.
std::string_view first_character(std::string_view text) {
    if ((static_cast<unsigned char>(text[0]) & 0xC0u) != 0xC0u) return text.substr(0, 1);
    std::size_t length = 1;
    while (length < 4 && length < text.size() && is_continuation(text[length])) ++length;
    return text.substr(0, length);
}

/// The length of a set at the beginning of `text`, brackets included; none when it is not closed.
std::optional<std::size_t> set_length(std::string_view text) {
    std::size_t at = 1;
    if (at < text.size() && (text[at] == '!' || text[at] == '^')) ++at;
    // A ] that comes first is one of the set.
    const std::size_t close = text.find(']', at + 1);
    if (close == std::string_view::npos) return {};
    return close + 1;
}

/// Characters compare as their bytes do: UTF-8 keeps their order.
bool set_holds(std::string_view set, std::string_view c) {
    const bool negated = set.starts_with('!') || set.starts_with('^');
    if (negated) set.remove_prefix(1);
    bool found = false;
    while (!set.empty()) {
        const std::string_view low = first_character(set);
        set.remove_prefix(low.size());
        std::string_view high = low;
        if (set.size() > 1 && set[0] == '-') {
            high = first_character(set.substr(1));
            set.remove_prefix(1 + high.size());
        }
        found = found || (low <= c && c <= high);
    }
    return found != negated;
}

/// The pattern as steps; none when it is malformed.
std::optional<std::vector<Step>> steps_of(std::string_view pattern) {
    std::vector<Step> steps;
    bool at_part_start = true;
    while (!pattern.empty()) {
        std::size_t length = 1;
        if (pattern[0] == '*') {
            length = std::min(pattern.find_first_not_of('*'), pattern.size());
            const bool whole_part =
                length == 2 && at_part_start && (pattern.size() == 2 || pattern[2] == '/');
            if (whole_part && pattern.size() > 2) ++length;  // `**/` may be nothing at all
            steps.push_back({whole_part ? Step::Kind::kManyFolders : Step::Kind::kManyInName,
                             pattern.substr(0, length)});
        } else if (pattern[0] == '?') {
            steps.push_back({Step::Kind::kAny, {}});
        } else if (pattern[0] == '[') {
            const auto found = set_length(pattern);
            if (!found) return {};
            length = *found;
            steps.push_back({Step::Kind::kSet, pattern.substr(1, length - 2)});
        } else {
            if (pattern[0] == '\\') pattern.remove_prefix(1);
            if (pattern.empty()) return {};
            const std::string_view one = first_character(pattern);
            length = one.size();
            steps.push_back({Step::Kind::kOne, one});
        }
        at_part_start = pattern.substr(0, length).ends_with('/');
        pattern.remove_prefix(length);
    }
    return steps;
}

bool step_takes(const Step& step, std::string_view c) {
    switch (step.kind) {
        case Step::Kind::kOne:
            return step.text == c;
        case Step::Kind::kSet:
            return c != "/" && set_holds(step.text, c);
        case Step::Kind::kAny:
        case Step::Kind::kManyInName:
            return c != "/";
        case Step::Kind::kManyFolders:
            break;
    }
    return true;
}

bool repeats(const Step& step) {
    return step.kind == Step::Kind::kManyInName || step.kind == Step::Kind::kManyFolders;
}

/// Follows all ways through the pattern at once, so that no pattern takes longer than its length
/// times the text's. `reached[s]`: the text so far fits the first s steps.
bool matches_steps(const std::vector<Step>& steps, std::string_view text) {
    std::vector<std::uint8_t> reached(steps.size() + 1, 0);
    reached[0] = 1;
    // A `**/` ends only where a part does; `inside` marks those that are within one.
    std::vector<std::uint8_t> inside(steps.size() + 1, 0);
    const auto skip_optional = [&] {
        for (std::size_t s = 0; s < steps.size(); ++s) {
            if (reached[s] && repeats(steps[s])) reached[s + 1] = 1;
        }
    };
    skip_optional();
    while (!text.empty()) {
        const std::string_view c = first_character(text);
        text.remove_prefix(c.size());
        std::vector<std::uint8_t> next(reached.size(), 0), next_inside(inside.size(), 0);
        for (std::size_t s = 0; s < steps.size(); ++s) {
            const Step& step = steps[s];
            if (step.kind == Step::Kind::kManyFolders && step.text.ends_with('/')) {
                if (!reached[s] && !inside[s]) continue;
                (c == "/" ? next[s] : next_inside[s]) = 1;
            } else if (reached[s] && step_takes(step, c)) {
                next[repeats(step) ? s : s + 1] = 1;
            }
        }
        reached = std::move(next);
        inside = std::move(next_inside);
        skip_optional();
    }
    return reached[steps.size()] != 0;
}

}  // namespace

Result<Glob> Glob::parse(std::string_view pattern) {
    Glob glob;
    std::string_view rest = pattern;
    if (rest.ends_with('/')) {
        glob.folders_only_ = true;
        rest.remove_suffix(1);
    }
    glob.names_only_ = rest.find('/') == std::string_view::npos;
    if (rest.starts_with('/')) rest.remove_prefix(1);
    glob.pattern_ = rest;
    if (rest.empty() || !steps_of(rest)) {
        return {ErrorCode::kInvalidArgument,
                "'" + std::string(pattern) +
                    "' is no pattern: expected names with *, ?, [a-z] and **, as in 'draft*.off' "
                    "or 'old/**'"};
    }
    return glob;
}

bool Glob::matches(std::string_view path, bool is_folder) const {
    if (folders_only_ && !is_folder) return false;
    if (names_only_) path.remove_prefix(path.rfind('/') + 1);  // npos + 1 is 0
    return matches_steps(*steps_of(pattern_), path);
}

}  // namespace ossuary::index
