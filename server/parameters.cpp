#include "server/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "index/report_text.h"

namespace ossuary::server {
namespace {

using enum RequestFault;

template <typename T>
std::optional<T> parse_number(std::string_view text) {
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (text.empty() || stop != end || fault != std::errc()) return std::nullopt;
    return value;
}

}  // namespace

ParameterReader::ParameterReader(const RequestHead& head) : fields_(head.parameters) {}

void ParameterReader::refuse(std::string_view name, std::string detail) {
    if (!fault_) fault_ = problem(kParameterInvalid, std::move(detail), std::string(name));
}

const std::string* ParameterReader::take(std::string_view name) {
    known_.emplace_back(name);
    const std::string* found = nullptr;
    for (const Field& field : fields_) {
        if (field.name != name) continue;
        if (found != nullptr && !fault_) {
            fault_ = problem(kParameterRepeated, "`" + std::string(name) + "` is given twice.",
                             std::string(name));
        }
        found = &field.value;
    }
    return found;
}

std::optional<std::string> ParameterReader::text(std::string_view name, std::size_t max_size,
                                                 std::size_t min_size) {
    const std::string* value = take(name);
    if (value == nullptr) return std::nullopt;
    if (value->size() < min_size || value->size() > max_size) {
        refuse(name, "`" + std::string(name) + "` must have " + std::to_string(min_size) + " to " +
                         std::to_string(max_size) + " bytes; it has " +
                         std::to_string(value->size()) + ".");
        return std::nullopt;
    }
    return *value;
}

std::optional<std::int64_t> ParameterReader::integer(std::string_view name, std::int64_t least,
                                                     std::int64_t most) {
    const std::string* value = take(name);
    if (value == nullptr) return std::nullopt;
    const auto number = parse_number<std::int64_t>(*value);
    if (!number || *number < least || *number > most) {
        const bool bounded = most < std::numeric_limits<std::int64_t>::max();
        refuse(name, "`" + std::string(name) + "` must be a whole number " +
                         (bounded ? "from " + std::to_string(least) + " to " + std::to_string(most)
                                  : "of at least " + std::to_string(least)) +
                         ".");
        return std::nullopt;
    }
    return number;
}

std::optional<double> ParameterReader::number(std::string_view name, double least, double most) {
    const std::string* value = take(name);
    if (value == nullptr) return std::nullopt;
    const auto number = parse_number<double>(*value);
    if (!number || !std::isfinite(*number) || *number < least || *number > most) {
        refuse(name, "`" + std::string(name) + "` must be a number from " + index::shortest(least) +
                         " to " + index::shortest(most) + ".");
        return std::nullopt;
    }
    return number;
}

std::optional<bool> ParameterReader::boolean(std::string_view name) {
    const auto value = choice(name, {"true", "false"});
    if (!value) return std::nullopt;
    return *value == "true";
}

std::optional<std::string> ParameterReader::choice(std::string_view name,
                                                   const std::vector<std::string_view>& choices) {
    const std::string* value = take(name);
    if (value == nullptr) return std::nullopt;
    if (std::find(choices.begin(), choices.end(), *value) == choices.end()) {
        std::string list;
        for (const std::string_view each : choices) {
            list += (list.empty() ? "`" : ", `") + std::string(each) + "`";
        }
        refuse(name, "`" + std::string(name) + "` must be " +
                         (choices.size() > 1 ? "one of " : "") + list + ".");
        return std::nullopt;
    }
    return *value;
}

void ParameterReader::require(std::string_view name) {
    const bool there = std::any_of(fields_.begin(), fields_.end(),
                                   [&](const Field& field) { return field.name == name; });
    if (!there && !fault_) {
        fault_ =
            problem(kParameterMissing, "`" + std::string(name) + "` is needed.", std::string(name));
    }
}

std::optional<Problem> ParameterReader::finish() const {
    if (fault_) return fault_;
    for (const Field& field : fields_) {
        if (std::find(known_.begin(), known_.end(), field.name) == known_.end()) {
            return problem(kParameterUnknown, "There is no parameter of this name here.",
                           field.name);
        }
    }
    return std::nullopt;
}

ranking::RankOptions read_rank_options(ParameterReader& reader, bool with_rerank) {
    ranking::RankOptions options;
    options.jobs = 0;
    std::vector<std::string_view> names;
    for (const ranking::RankerKind kind : ranking::kAllRankers) names.push_back(to_string(kind));
    if (const auto name = reader.choice("ranker", names)) {
        if (const auto kind = ranking::parse_ranker(*name)) options.ranker = *kind;
    }
    options.pose = reader.number("pose", 0.0, 1.0).value_or(options.pose);
    options.size = reader.number("size", 0.0, 1.0).value_or(options.size);
    if (with_rerank) options.rerank = reader.boolean("rerank").value_or(options.rerank);
    options.part = reader.boolean("part").value_or(options.part);
    if (options.part && options.rerank) {
        reader.refuse("rerank", "`rerank` does not go together with `part`.");
    }
    return options;
}

index::SearchOptions read_search_options(ParameterReader& reader) {
    index::SearchOptions options;
    options.limit = static_cast<std::size_t>(
        reader.integer("limit", 1, 1000).value_or(static_cast<std::int64_t>(options.limit)));
    options.rank = read_rank_options(reader, true);
    options.class_filter = reader.text("class").value_or("");
    options.folder = reader.text("folder", 1024);
    options.kind = reader.text("kind", 16);
    options.fold_copies = reader.boolean("fold").value_or(options.fold_copies);
    return options;
}

voxel::InsideOptions read_inside(ParameterReader& reader) {
    constexpr double kMost = std::numeric_limits<double>::max();
    voxel::InsideOptions inside;
    inside.threshold = reader.number("threshold", -kMost, kMost);
    inside.label = reader.number("label", -kMost, kMost);
    if (inside.threshold && inside.label) {
        reader.refuse("label", "`label` does not go together with `threshold`.");
    }
    return inside;
}

Checked<std::int64_t> parse_id(std::string_view text, std::string_view what) {
    const auto id = parse_number<std::int64_t>(text);
    if (id && *id >= 1) return *id;
    return tl::unexpected<Problem>(
        problem(kParameterInvalid,
                "A " + std::string(what) + "'s id is a whole number of at least 1.", "id"));
}

}  // namespace ossuary::server
