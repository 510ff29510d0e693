// SPDX-License-Identifier: MIT
#include "cli/report.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/laboratory.hpp"
#include "cli/read_text.hpp"
#include "report/accuracy.hpp"
#include "report/check_page.hpp"
#include "report/matrix.hpp"
#include "report/merge.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

struct ReportOptions {
    std::vector<std::string> files;
    std::filesystem::path json;
    std::filesystem::path html;
    bool markdown = false;
    bool accuracy = false;
    bool summary = false;
    std::filesystem::path since;
    std::filesystem::path lines;
};

std::vector<report::ReportFile> read_reports(const std::vector<std::string>& files) {
    std::vector<report::ReportFile> all;
    for (const std::string& file : files) {
        const std::string text = read_text(file);
        try {
            for (report::CheckReport& report : report::reports_from_json(text)) {
                all.push_back({.file = file, .report = std::move(report)});
            }
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("{} is not what `gloam check --json` writes: {}", file, error.what()));
        }
    }
    return all;
}

std::string page_of(const report::MergedReports& merged, const ReportOptions& options) {
    if (options.accuracy) return report::to_accuracy_markdown(merged.reports);
    return options.markdown ? report::to_matrix_markdown(merged.reports) : report::to_matrix(merged.reports);
}

int run_report(const ReportOptions& options) {
    if (options.summary)
        return run_summary(
            {.paths = options.files, .since = options.since, .lines = options.lines, .html = options.html});
    const report::OutputFile json(options.json);
    const report::OutputFile html(options.html);
    const report::MergedReports merged = report::merge(read_reports(options.files));
    fmt::print("{}", page_of(merged, options));
    for (const std::string& conflict : merged.conflicts)
        fmt::print("\n{}{}\n", options.markdown || options.accuracy ? "- " : "", conflict);
    json.write(report::to_json(merged.reports));
    html.write(report::to_check_page(merged.reports, merged.conflicts));
    return counts_of(merged.reports).exit_status();
}

}  // namespace

void add_report(CLI::App& app, int& status) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command =
        app.add_subcommand("report", "merge the results of `gloam check --json` from many machines");
    command
        ->add_option("file", options->files, "JSON files of gloam check; with --summary also folders of them")
        ->required();
    command->add_flag("--markdown", options->markdown, "a Markdown page instead of a table for the terminal");
    command
        ->add_flag("--accuracy", options->accuracy,
                   "tables of Markdown: how much of their documented error equations use on each device")
        ->excludes("--markdown");
    CLI::Option* json = command->add_option("--json", options->json, "write the merged results to this file");
    CLI::Option* summary =
        command
            ->add_flag("--summary", options->summary,
                       "instead: counts for each driver and check, from any number of files")
            ->excludes("--markdown")
            ->excludes("--accuracy")
            ->excludes(json);
    command
        ->add_option("--since", options->since,
                     "the --lines of an earlier summary: say what is new since then")
        ->needs(summary);
    command
        ->add_option("--lines", options->lines,
                     "write the summary as JSON lines, one for each driver and check")
        ->needs(summary);
    command->add_option("--html", options->html,
                        "write the results as a page: sortable, filterable, in one file");
    command->callback([options, &status] { status = run_report(*options); });
}

}  // namespace gloam::cli
