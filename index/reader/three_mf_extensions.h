#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::index {

/// The namespaces of the extensions that the first tag `<model …>` of a model part requires; a
/// prefix that stands for none is given as it is.
[[nodiscard]] std::vector<std::string> required_extensions(std::string_view model_part);

/// Looks at the model parts of a package for extensions that lib3mf does not know and the file
/// requires, which lib3mf itself refuses without a name. A package that cannot be opened passes: it
/// is for lib3mf to say what is wrong with it.
/// Errors: three_mf_extension.
Result<void> check_required_extensions(std::string_view package);

}  // namespace ossuary::index
