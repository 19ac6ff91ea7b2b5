#pragma once

#include <chrono>
#include <string_view>

#include "index/indexer.h"

namespace ossuary::cli {

/// Shows indexing on stderr: one line that is redrawn on a terminal, a line every ten seconds
/// elsewhere; every failure as a line of its own.
class ConsoleProgress : public index::ProgressSink {
public:
    ConsoleProgress();
    ~ConsoleProgress() override;
    ConsoleProgress(const ConsoleProgress&) = delete;
    ConsoleProgress& operator=(const ConsoleProgress&) = delete;

    void found(const index::FoundFiles& found) override;
    void progress(const index::IndexProgress& progress) override;
    void failed(const index::Failure& failure) override;
    void phase(std::string_view what) override;

private:
    using Clock = std::chrono::steady_clock;
    void clear_line();

    bool terminal_;
    bool line_drawn_ = false;
    Clock::time_point last_drawn_;
};

}  // namespace ossuary::cli
