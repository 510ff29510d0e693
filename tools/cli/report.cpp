// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "base/threads.hpp"
#include "cli/arguments.hpp"
#include "cli/progress.hpp"
#include "report/accuracy.hpp"
#include "report/check_page.hpp"
#include "report/check_report.hpp"
#include "report/laboratory.hpp"
#include "report/output.hpp"
#include "report/results_database.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
using report::LaboratorySummary;

struct ReportOptions {
    std::vector<std::string> files;  // and, with --summary, folders of which all *.json files count
    std::filesystem::path json;
    std::filesystem::path html;
    bool markdown = false;
    bool accuracy = false;
    bool summary = false;
    std::filesystem::path since;     // a database of earlier results; empty: none
    std::filesystem::path database;  // receives the results; empty: none
};

constexpr std::size_t most_rejected = 20;  // named; the others are counted

// The files, and those of the folders, sorted. Links inside a folder are not followed, and what is hidden
// there is left out: `gloam work run` may be writing it.
std::vector<fs::path> files_of(const std::vector<std::string>& paths) {
    std::vector<fs::path> files;
    for (const fs::path path : paths) {
        if (!fs::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const auto first = static_cast<std::ptrdiff_t>(files.size());
        for (auto entry = fs::recursive_directory_iterator(path); entry != fs::recursive_directory_iterator();
             ++entry) {
            if (entry->path().filename().string().starts_with('.')) {
                entry.disable_recursion_pending();
            } else if (!entry->is_symlink() && entry->is_regular_file() &&
                       entry->path().extension() == ".json") {
                files.push_back(entry->path());
            }
        }
        std::sort(files.begin() + first, files.end());
    }
    return files;
}

// Reads files one after another, on every processor, and forgets each before the next one.
class Gathering {
  public:
    Gathering(const std::vector<fs::path>& files, report::ResultsDatabase& database)
        : files_(&files),
          database_(&database),
          progress_(progress_bar(fmt::format("{} files", files.size()))) {}

    // Returns a line for each file that is no result, sorted.
    std::vector<std::string> run() {
        base::for_each_index(files_->size(), 0, [&](std::size_t i) { take((*files_)[i]); });
        std::ranges::sort(rejected_);
        return std::move(rejected_);
    }

  private:
    void take(const fs::path& file) {
        std::string why;
        try {
            database_->add(read_text(file));
        } catch (const std::runtime_error& error) {
            why = error.what();
        }
        const std::lock_guard lock(mutex_);
        if (!why.empty())
            rejected_.push_back(base::one_line(
                fmt::format("{} is not what `gloam check --json` writes: {}", file.string(), why)));
        progress_(static_cast<double>(++done_) / static_cast<double>(files_->size()));
    }

    const std::vector<fs::path>* files_;
    report::ResultsDatabase* database_;
    std::function<void(double)> progress_;
    std::mutex mutex_;  // of the members below and the progress
    std::size_t done_ = 0;
    std::vector<std::string> rejected_;
};

// The first of them, and how many more there are.
std::vector<std::string> shortened(std::vector<std::string> lines) {
    if (lines.size() <= most_rejected) return lines;
    const std::size_t more = lines.size() - most_rejected;
    lines.resize(most_rejected);
    lines.push_back(fmt::format("and {} more files that are no results", more));
    return lines;
}

// Adds the results of many machines to the database, summarises what it holds, and prints that. Files that
// are no results are named on standard error, and the others count. Returns the exit status: 0; 1 if a check
// failed or a file is no result. Throws std::runtime_error if no file is a result; then the database remains
// as it was.
int run_summary(const ReportOptions& options) {
    using report::ResultsDatabase;
    const report::OutputFile html(options.html);
    std::optional<LaboratorySummary> earlier;
    if (!options.since.empty())
        earlier = ResultsDatabase(options.since, ResultsDatabase::Access::read).summary();
    if (options.files.empty() && options.database.empty())
        throw std::invalid_argument("report --summary: expected files, or --sqlite FILE with results");
    const bool reads = options.files.empty();
    ResultsDatabase database(options.database,
                             reads ? ResultsDatabase::Access::read : ResultsDatabase::Access::add);
    const std::vector<fs::path> files = files_of(options.files);
    const std::vector<std::string> all_rejected = Gathering(files, database).run();
    const std::vector<std::string> rejected = shortened(all_rejected);
    if (files.size() == 1 && !rejected.empty()) throw std::runtime_error(rejected.front());
    for (const std::string& line : rejected) fmt::print(stderr, "gloam: {}\n", line);
    if (!reads && all_rejected.size() == files.size())
        throw std::runtime_error(
            fmt::format("none of {} files holds results of `gloam check --json`", files.size()));
    database.commit();
    const LaboratorySummary summary = database.summary();
    std::optional<report::News> news;
    if (earlier) news = report::news_since(*earlier, summary);
    fmt::print("{}", report::to_summary_text(summary, news));
    html.write(report::to_summary_page(summary, news, rejected));
    const bool failed =
        std::ranges::any_of(summary, [](const auto& group) { return group.second.failing() > 0; });
    return failed || !rejected.empty() ? 1 : 0;
}

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
    if (options.summary) return run_summary(options);
    if (options.files.empty()) throw std::invalid_argument("report: expected at least one file");
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
    command->add_option("file", options->files,
                        "JSON files of gloam check; with --summary also folders of them");
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
        ->add_option("--sqlite", options->database,
                     "add the results to this SQLite file, which is made if it is missing, and summarise all "
                     "that it holds; a result that it holds counts once")
        ->needs(summary);
    command
        ->add_option("--since", options->since,
                     "such a file of earlier results: say what got better and worse since then")
        ->needs(summary);
    command->add_option("--html", options->html,
                        "write the results as a page: sortable, filterable, in one file");
    command->callback([options, &status] { status = run_report(*options); });
}

}  // namespace gloam::cli
