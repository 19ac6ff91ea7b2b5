#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::ranking {

/// What a Princeton classification file (.cla, format "PSB 1") says: a tree of classes, each with
/// models of its own. Only classes that list models themselves count when retrieval is evaluated;
/// `tree` and its child `barren` may both have some, and are then two classes.
struct Classification {
    struct Class {
        std::string name;                 ///< unique in the file
        std::string parent;               ///< empty at the top ("0" in the file)
        std::vector<std::string> models;  ///< ids as written, e.g. "1298"
    };
    std::vector<Class> classes;  ///< in the order of the file, parents before their children

    [[nodiscard]] std::size_t model_count() const;
};

struct ClassifiedModel {
    std::string id;
    std::string class_name;
};

/// All models with their classes in the order of the file, which is the order of rows and columns
/// of a Princeton distance matrix.
[[nodiscard]] std::vector<ClassifiedModel> models_in_order(const Classification& classification);

/// The names from the top to `class_name`, joined by '/': "aircraft/airplane/F117".
/// @pre the classification has that class
[[nodiscard]] std::string full_class_name(const Classification& classification,
                                          std::string_view class_name);

/// The file names that an id may stand for, best first: "12" is 12.off (segmentation benchmark) or
/// m12.off (shape benchmark), then the same as .stl, .obj and .ply; an id that ends in one of these
/// already is itself.
[[nodiscard]] std::vector<std::string> candidate_file_names(std::string_view id);

/// Parses the text of a classification file: "PSB 1", then the numbers of classes and models, then
/// for each class one line `name parent count` followed by `count` lines with one id each. Blank
/// lines, CRLF and a byte order mark are skipped. `name` stands for the file in messages.
/// Errors: cla_invalid with the line (wrong header, counts that do not agree with what follows,
/// unknown parents, classes or models named twice).
Result<Classification> parse_classification(std::string_view text, std::string_view name);

/// Reads a file of at most 64 MiB. Errors: file_not_found, file_unreadable, file_too_large, and
/// those of parse_classification.
Result<Classification> read_classification(const std::filesystem::path& path);

}  // namespace ossuary::ranking
