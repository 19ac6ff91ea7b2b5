#include "tests/support/source_folder.h"

namespace ossuary::test {

std::filesystem::path source_folder() { return OSSUARY_SOURCE_DIR; }

}  // namespace ossuary::test
