#pragma once

#include <functional>
#include <string_view>

namespace ossuary {

/// Told the name of each stage of long work as it begins (those of StageTimes), on the thread that
/// does it; empty where nobody wants to know.
using StageReport = std::function<void(std::string_view stage)>;

}  // namespace ossuary
