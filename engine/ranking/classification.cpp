#include "engine/ranking/classification.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "engine/core/whole_file.h"

namespace ossuary::ranking {
namespace {

constexpr std::uintmax_t kMaxBytes = 64u << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Line {
    std::size_t number = 0;  // 1-based
    std::vector<std::string_view> words;
};

/// Gives the lines that have words, one after the other.
class LineReader {
public:
    LineReader(std::string_view text, std::string_view name) : text_(text), name_(name) {
        if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
    }

    std::optional<Line> next() {
        while (position_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', position_), text_.size());
            Line line{++number_, split(text_.substr(position_, end - position_))};
            position_ = end + 1;
            if (!line.words.empty()) return line;
        }
        return std::nullopt;
    }

    /// An error at the line that was read last.
    [[nodiscard]] Error error(std::string_view what) const {
        return {ErrorCode::kClaInvalid, std::string(name_) + " line " +
                                            std::to_string(std::max<std::size_t>(number_, 1)) +
                                            ": " + std::string(what)};
    }

private:
    static std::vector<std::string_view> split(std::string_view line) {
        constexpr std::string_view kBlank = " \t\r\v\f";
        std::vector<std::string_view> words;
        for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;) {
            const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
            words.push_back(line.substr(begin, end - begin));
            begin = line.find_first_not_of(kBlank, end);
        }
        return words;
    }

    std::string_view text_;
    std::string_view name_;
    std::size_t position_ = 0;
    std::size_t number_ = 0;
};

std::optional<std::size_t> parse_count(std::string_view word) {
    std::uint32_t value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// The words as a person would quote them, cut where they get long or unprintable.
std::string quoted(const std::vector<std::string_view>& words) {
    std::string text = "'";
    for (const std::string_view word : words) {
        if (text.size() > 1) text += ' ';
        for (const char c : word.substr(0, 40)) {
            const auto byte = static_cast<unsigned char>(c);
            text += byte < 0x20 || byte >= 0x7F ? '?' : c;
        }
        if (text.size() > 80) return text + "...'";
    }
    return text + "'";
}

struct Counts {
    std::size_t classes = 0;
    std::size_t models = 0;
};

Result<Counts> read_header(LineReader& reader) {
    const auto magic = reader.next();
    if (!magic) return reader.error("empty file; expected 'PSB 1'");
    if (magic->words.size() != 2 || magic->words[0] != "PSB" || magic->words[1] != "1") {
        return reader.error("found " + quoted(magic->words) + "; expected 'PSB 1'");
    }
    const auto line = reader.next();
    if (!line) return reader.error("file ends; expected the numbers of classes and models");
    const auto fail = [&] {
        return reader.error("found " + quoted(line->words) +
                            "; expected the numbers of classes and models");
    };
    if (line->words.size() != 2) return fail();
    const auto classes = parse_count(line->words[0]);
    const auto models = parse_count(line->words[1]);
    if (!classes || !models) return fail();
    return Counts{*classes, *models};
}

/// Reads the classes and remembers what has been named where.
class ClassReader {
public:
    explicit ClassReader(LineReader& reader) : reader_(reader) {}

    Result<void> read_class(const Line& line) {
        if (line.words.size() != 3) {
            return reader_.error("found " + quoted(line.words) +
                                 "; expected a class as 'name parent count'");
        }
        const std::string name(line.words[0]);
        const std::string parent(line.words[1]);
        const auto count = parse_count(line.words[2]);
        if (!count) {
            return reader_.error("class " + quoted({name}) + " has " + quoted({line.words[2]}) +
                                 " models; expected a whole number");
        }
        if (name == "0") return reader_.error("a class is named '0', which stands for the top");
        if (parent != "0" && !class_lines_.contains(parent)) {
            return reader_.error("class " + quoted({name}) + " has the parent " + quoted({parent}) +
                                 "; expected '0' or a class from above");
        }
        const auto [earlier, is_new] = class_lines_.try_emplace(name, line.number);
        if (!is_new) {
            return reader_.error("class " + quoted({name}) + " stands on line " +
                                 std::to_string(earlier->second) + " already");
        }
        result_.classes.push_back({name, parent == "0" ? "" : parent, {}});
        return read_models(*count);
    }

    [[nodiscard]] Classification take() && { return std::move(result_); }
    [[nodiscard]] std::size_t class_count() const { return result_.classes.size(); }
    [[nodiscard]] std::size_t model_count() const { return model_lines_.size(); }

private:
    Result<void> read_models(std::size_t count) {
        Classification::Class& current = result_.classes.back();
        const auto expected = [&] {
            return "; expected model " + std::to_string(current.models.size() + 1) + " of " +
                   std::to_string(count) + " of class " + quoted({current.name});
        };
        while (current.models.size() < count) {
            const auto line = reader_.next();
            if (!line) return reader_.error("file ends" + expected());
            if (line->words.size() != 1) {
                return reader_.error("found " + quoted(line->words) + expected());
            }
            const std::string id(line->words[0]);
            const auto [earlier, is_new] = model_lines_.try_emplace(id, line->number);
            if (!is_new) {
                return reader_.error("model " + quoted({id}) + " stands on line " +
                                     std::to_string(earlier->second) + " already");
            }
            current.models.push_back(id);
        }
        return {};
    }

    LineReader& reader_;
    Classification result_;
    std::unordered_map<std::string, std::size_t> class_lines_;
    std::unordered_map<std::string, std::size_t> model_lines_;
};

}  // namespace

std::size_t Classification::model_count() const {
    std::size_t total = 0;
    for (const Class& entry : classes) total += entry.models.size();
    return total;
}

std::vector<ClassifiedModel> models_in_order(const Classification& classification) {
    std::vector<ClassifiedModel> models;
    models.reserve(classification.model_count());
    for (const Classification::Class& entry : classification.classes) {
        for (const std::string& id : entry.models) models.push_back({id, entry.name});
    }
    return models;
}

std::string full_class_name(const Classification& classification, std::string_view class_name) {
    const auto find = [&](std::string_view name) {
        const auto found =
            std::find_if(classification.classes.begin(), classification.classes.end(),
                         [&](const auto& entry) { return entry.name == name; });
        assert(found != classification.classes.end());
        return found;
    };
    auto current = find(class_name);
    std::string path = current->name;
    while (!current->parent.empty()) {
        current = find(current->parent);
        path.insert(0, current->name + "/");
    }
    return path;
}

std::vector<std::string> candidate_file_names(std::string_view id) {
    constexpr std::array<std::string_view, 4> kExtensions = {".off", ".stl", ".obj", ".ply"};
    const std::string name(id);
    std::vector<std::string> names;
    for (const std::string_view extension : kExtensions) {
        if (id.ends_with(extension)) return {name};
        for (const char* prefix : {"", "m"}) {
            names.push_back(prefix + name + std::string(extension));
        }
    }
    return names;
}

Result<Classification> parse_classification(std::string_view text, std::string_view name) {
    LineReader reader(text, name);
    const Result<Counts> counts = read_header(reader);
    if (!counts) return counts.error();
    ClassReader classes(reader);
    while (const auto line = reader.next()) {
        const Result<void> read = classes.read_class(*line);
        if (!read) return read.error();
    }
    if (classes.class_count() != counts->classes || classes.model_count() != counts->models) {
        return reader.error("file ends after " + std::to_string(classes.class_count()) +
                            " classes and " + std::to_string(classes.model_count()) +
                            " models; the header says " + std::to_string(counts->classes) +
                            " and " + std::to_string(counts->models));
    }
    return std::move(classes).take();
}

Result<Classification> read_classification(const std::filesystem::path& path) {
    const Result<WholeFile> file = read_whole_file(path, kMaxBytes);
    if (!file) return file.error();
    return parse_classification(file->view(), path.string());
}

}  // namespace ossuary::ranking
