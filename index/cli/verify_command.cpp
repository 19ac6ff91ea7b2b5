#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "index/cli/command.h"
#include "index/cli/console.h"
#include "index/cli/options.h"
#include "index/migrations.h"
#include "index/presentation.h"

namespace ossuary::cli {
namespace {

Result<ExitCode> run(const std::string& index_path, const Session& session) {
    Result<index::Store> store = index::Store::open(index_path, index::Access::kInspect);
    if (!store.ok()) return store.error();
    const Result<index::VerifyReport> report = store->verify();
    if (!report.ok()) return report.error();
    if (session.json) {
        print_json(index::to_json(*report));
    } else {
        for (const index::Finding& finding : report->findings) {
            std::cout << terminal_format("{}: {}\n", finding.subject, finding.message);
        }
        std::cout << terminal_format(
            "{} models, {} blobs, {} failures, revision {}: {}\n", report->models, report->blobs,
            report->failures, report->revision,
            report->findings.empty() ? std::string("clean")
                                     : fmt::format("{} findings", report->findings.size()));
    }
    if (report->version < index::schema_version()) {
        std::cerr << terminal_format(
            "{}: an index of version {}; any other command migrates it to version {}\n", index_path,
            report->version, index::schema_version());
    }
    return report->findings.empty() ? ExitCode::kDone : ExitCode::kNotAnIndex;
}

}  // namespace

void add_verify(CLI::App& app, Session& session) {
    auto index_path = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("verify", "Check every byte that an index holds");
    add_index_option(*command, *index_path);
    set_body(*command, session, [index_path, &session] { return run(*index_path, session); });
}

}  // namespace ossuary::cli
