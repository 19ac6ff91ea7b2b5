#include "engine/mesh/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/mesh/colours_on.h"
#include "engine/mesh/line_numbers.h"
#include "engine/mesh/obj_lines.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// `Kd` with one number, which stands for all three, or three.
std::optional<Colour> diffuse_colour(TextScanner& scanner) {
    const LineNumbers numbers = read_line_numbers(scanner);
    if (numbers.count != 1 && numbers.count != 3) return {};
    const std::array<float, 3> read = numbers.three_from(0);
    Colour colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const float share = read[numbers.count == 1 ? 0 : channel];
        if (!std::isfinite(share)) return {};
        colour[channel] =
            static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
    }
    return colour;
}

void add_once(std::vector<std::string>& names, std::string_view name) {
    std::string file(name);
    std::replace(file.begin(), file.end(), '\\', '/');
    if (file.empty() || std::find(names.begin(), names.end(), file) != names.end()) return;
    names.push_back(std::move(file));
}

/// What stands between blanks, where there are any.
void add_words(std::vector<std::string>& names, std::string_view line) {
    while (!line.empty()) {
        const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
        add_once(names, line.substr(0, end));
        line = trimmed(line.substr(end));
    }
}

}  // namespace

MaterialColours read_material_colours(std::string_view library) {
    MaterialColours colours;
    std::string material;
    ObjLines lines(library);
    while (lines.next()) {
        TextScanner scanner(lines.text());
        if (scanner.at_line_end()) continue;
        const std::string_view word = scanner.peek_token();
        scanner.advance(word.size());
        if (word == "newmtl") {
            material = trimmed(lines.text().substr(lines.text().size() - scanner.bytes_left()));
        } else if (word == "Kd") {
            if (const auto colour = diffuse_colour(scanner)) colours[material] = *colour;
        }
    }
    return colours;
}

std::vector<std::string> material_libraries(std::string_view obj) {
    constexpr std::string_view kWord = "mtllib";
    constexpr std::string_view kNewlines = "\r\n";
    constexpr std::size_t kMostNames = 1000;
    std::vector<std::string> names;
    for (std::size_t at = obj.find(kWord);
         at != std::string_view::npos && names.size() < kMostNames; at = obj.find(kWord, at)) {
        const std::size_t before = at == 0 ? at : obj.find_last_not_of(kBlanks, at - 1);
        const bool begins_line = at == 0 || before == std::string_view::npos ||
                                 kNewlines.find(obj[before]) != std::string_view::npos;
        at += kWord.size();
        if (!begins_line || at == obj.size() || kBlanks.find(obj[at]) == std::string_view::npos) {
            continue;
        }
        const std::size_t end = std::min(obj.find_first_of(kNewlines, at), obj.size());
        const std::string_view line = trimmed(obj.substr(at, end - at));
        add_once(names, line);
        add_words(names, line);
    }
    return names;
}

void colour_by_materials(ReadMeshResult& model, const MaterialColours& colours) {
    TriangleMesh& mesh = model.mesh;
    if (!mesh.corner_colours.empty()) return;
    for (const ModelObject& run : model.materials) {
        const auto colour = colours.find(run.name);
        if (colour == colours.end()) continue;
        mesh.corner_colours.resize(mesh.triangles.size(),
                                   {kPlainColour, kPlainColour, kPlainColour});
        std::fill_n(mesh.corner_colours.begin() + run.first_triangle, run.triangles,
                    CornerColours{colour->second, colour->second, colour->second});
    }
    if (is_white(mesh)) mesh.corner_colours = {};
}

}  // namespace ossuary::mesh
