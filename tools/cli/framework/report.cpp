// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "base/files.hpp"
#include "record/check_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

struct ReportOptions {
    std::vector<std::string> files;
    std::string since;  // a file of an earlier run; empty: none
    std::filesystem::path json;
    std::filesystem::path html;
    bool markdown = false;
};

std::vector<record::ReportFile> read_reports(const std::vector<std::string>& files) {
    std::vector<record::ReportFile> all;
    for (const std::string& file : files) {
        const std::string text = base::read_file(file);
        if (text.starts_with(R"({"check_journal")"))
            throw std::runtime_error(fmt::format(
                "{} is the journal of a run that did not end: run its command again, with --resume", file));
        try {
            for (record::CheckReport& report : record::reports_from_json(text))
                all.push_back({.file = file, .report = std::move(report)});
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("{} is not what `gloam check --json` writes: {}", file, error.what()));
        }
    }
    return all;
}

int run_report(const ReportOptions& options) {
    const record::OutputFile json(options.json);
    const record::OutputFile html(options.html);
    const record::MergedReports merged = record::merge(read_reports(options.files));
    std::vector<std::string> notes = merged.conflicts;
    notes.insert(notes.end(), merged.missing.begin(), merged.missing.end());
    if (!options.since.empty()) {
        const record::MergedReports before = record::merge(read_reports({options.since}));
        const std::vector<std::string> changes = record::changes_since(before.reports, merged.reports);
        notes.insert(notes.end(), changes.begin(), changes.end());
        if (changes.empty()) notes.push_back("nothing changed since " + options.since);
    }
    fmt::print("{}", (options.markdown ? record::to_matrix_markdown : record::to_matrix)(merged.reports));
    for (const std::string& note : notes) fmt::print("\n{}{}\n", options.markdown ? "- " : "", note);
    json.write(record::to_json(merged.reports));
    html.write(record::to_check_page(merged.reports, notes));
    const int status = counts_of(merged.reports).exit_status();
    return status == 0 && !merged.missing.empty() ? 2 : status;
}

}  // namespace

Command report_command() {
    static ReportOptions options;
    return {
        .name = "report",
        .about = "merge the results of `gloam check --json` from many machines",
        .options = {{"file", &options.files, required, "JSON files of gloam check"},
                    {"--markdown", &options.markdown, "a Markdown page instead of a table for the terminal"},
                    {"--json", &options.json, "write the merged results to this file"},
                    {"--since", &options.since,
                     "results of an earlier run: say what got better and worse since then"},
                    {"--html", &options.html,
                     "write the results as a page: sortable, filterable, in one file"}},
        .run = [] { return run_report(options); },
        .examples =
            "  gloam report a.json b.json\n"
            "  gloam report a.json b.json --html all.html\n"
            "  gloam report now.json --since last-week.json\n"};
}

}  // namespace gloam::cli
