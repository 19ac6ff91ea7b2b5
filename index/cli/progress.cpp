#include "index/cli/progress.h"

#include <fmt/format.h>

#include <iostream>

#include "index/cli/console.h"

namespace ossuary::cli {
namespace {

using namespace std::chrono_literals;

std::string progress_line(const index::IndexProgress& progress) {
    const double share = progress.total == 0 ? 1.0
                                             : static_cast<double>(progress.done) /
                                                   static_cast<double>(progress.total);
    std::string line =
        fmt::format("{:3.0f} %  {} of {}", 100.0 * share, progress.done, progress.total);
    if (progress.models_per_second > 0.0) {
        line += fmt::format("  {:.1f} models/s", progress.models_per_second);
    }
    if (progress.done < progress.total && progress.eta_seconds > 0.0) {
        line += fmt::format("  {} left", duration_text(progress.eta_seconds));
    }
    if (progress.unchanged > 0) line += fmt::format("  {} unchanged", progress.unchanged);
    if (progress.failed > 0) line += fmt::format("  {} failed", progress.failed);
    return line;
}

std::string warning_line(std::string_view code, std::string_view message) {
    return std::string(style(Style::kWarning)) + terminal_text(code) +
           std::string(style(Style::kPlain)) + terminal_format(": {}", message);
}

/// "hidden 3, excluded 1"; empty where nothing was passed over.
std::string passed_over_text(const index::PassedOver& counts) {
    std::string text;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, count);
    };
    add(counts.hidden, "hidden");
    add(counts.excluded, "excluded");
    add(counts.seen_before, "already taken by another path");
    add(counts.broken_links, "links that lead nowhere");
    add(counts.special, "pipes and the like");
    add(counts.other_files, "files that are no models");
    return text;
}

// Readers of files name the file themselves; later stages do not know it.
std::string failure_line(const index::Failure& failure) {
    const std::string where =
        failure.message.find(failure.path) == std::string::npos ? failure.path + ": " : "";
    return warning_line(failure.code, where + failure.message);
}

}  // namespace

void ConsoleProgress::found(const index::FoundFiles& found) {
    for (const index::UnreadableFolder& folder : found.unreadable) {
        std::cerr << warning_line(to_string(folder.error.code), folder.error.message) << '\n';
    }
    const std::string passed_over = passed_over_text(found.passed_over);
    if (!passed_over.empty()) std::cerr << "passed over: " << passed_over << '\n';
}

ConsoleProgress::ConsoleProgress() : terminal_(stderr_is_terminal()), last_drawn_(Clock::now()) {}

ConsoleProgress::~ConsoleProgress() { clear_line(); }

void ConsoleProgress::clear_line() {
    if (line_drawn_) std::cerr << "\r\033[K" << std::flush;
    line_drawn_ = false;
}

void ConsoleProgress::progress(const index::IndexProgress& progress) {
    const auto now = Clock::now();
    const bool last = progress.done == progress.total;
    if (terminal_) {
        if (!last && line_drawn_ && now - last_drawn_ < 100ms) return;
        std::cerr << "\r\033[K" << progress_line(progress) << std::flush;
        line_drawn_ = true;
        last_drawn_ = now;
    } else if (now - last_drawn_ >= 10s) {
        std::cerr << progress_line(progress) << '\n';
        last_drawn_ = now;
    }
}

void ConsoleProgress::failed(const index::Failure& failure) {
    clear_line();
    std::cerr << failure_line(failure) << '\n';
}

void ConsoleProgress::phase(std::string_view what) {
    if (!terminal_) return;
    std::cerr << "\r\033[K" << terminal_text(what) << std::flush;
    line_drawn_ = true;
}

}  // namespace ossuary::cli
