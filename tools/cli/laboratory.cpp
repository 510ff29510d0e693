// SPDX-License-Identifier: MIT
#include "cli/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "base/text.hpp"
#include "cli/progress.hpp"
#include "cli/read_text.hpp"
#include "report/laboratory/summary_page.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
using report::LaboratorySummary;

constexpr std::size_t most_rejected = 20;  // named; the others are counted

// The files, and those of the folders, sorted. Links inside a folder are not followed.
std::vector<fs::path> files_of(const std::vector<std::string>& paths) {
    std::vector<fs::path> files;
    for (const fs::path path : paths) {
        if (!fs::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const auto first = static_cast<std::ptrdiff_t>(files.size());
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
            if (!entry.is_symlink() && entry.is_regular_file() && entry.path().extension() == ".json")
                files.push_back(entry.path());
        std::sort(files.begin() + first, files.end());
    }
    return files;
}

struct Gathered {
    LaboratorySummary summary;
    std::vector<std::string> rejected;  // a line each, sorted
};

// Reads files one after another, on every processor, and forgets each before the next one.
class Gathering {
  public:
    explicit Gathering(const std::vector<fs::path>& files)
        : files_(&files), progress_(progress_bar(fmt::format("{} files", files.size()))) {}

    Gathered run() {
        std::vector<std::future<LaboratorySummary>> workers;
        for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
            workers.push_back(std::async(std::launch::async, [this] { return part(); }));
        Gathered all;
        for (auto& worker : workers) all.summary.merge(worker.get());
        std::ranges::sort(rejected_);
        all.rejected = std::move(rejected_);
        return all;
    }

  private:
    LaboratorySummary part() {
        LaboratorySummary summary;
        for (std::size_t i = next_++; i < files_->size(); i = next_++) {
            const fs::path& file = (*files_)[i];
            try {
                summary.add_file(read_text(file));
            } catch (const std::runtime_error& error) {
                reject(file, error.what());
            }
            const std::lock_guard lock(mutex_);
            progress_(static_cast<double>(++done_) / static_cast<double>(files_->size()));
        }
        return summary;
    }

    void reject(const fs::path& file, const char* why) {
        const std::lock_guard lock(mutex_);
        rejected_.push_back(base::one_line(
            fmt::format("{} is not what `gloam check --json` writes: {}", file.string(), why)));
    }

    const std::vector<fs::path>* files_;
    std::function<void(double)> progress_;
    std::atomic<std::size_t> next_ = 0;
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

std::optional<report::EarlierSummary> earlier_of(const fs::path& file) {
    if (file.empty()) return std::nullopt;
    std::ifstream lines(file);
    try {
        if (!lines || fs::is_directory(file)) throw std::runtime_error("cannot be read");
        return report::earlier_from_lines(lines);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("--since {}: expected the JSON lines of an earlier summary: {}",
                                             file.string(), error.what()));
    }
}

}  // namespace

int run_summary(const SummaryOptions& options) {
    const report::OutputFile lines(options.lines);
    const report::OutputFile html(options.html);
    const std::optional<report::EarlierSummary> earlier = earlier_of(options.since);
    const std::vector<fs::path> files = files_of(options.paths);
    const Gathered all = Gathering(files).run();
    const std::vector<std::string> rejected = shortened(all.rejected);
    if (files.size() == 1 && !rejected.empty()) throw std::runtime_error(rejected.front());
    for (const std::string& line : rejected) fmt::print(stderr, "gloam: {}\n", line);
    if (all.summary.files() == 0)
        throw std::runtime_error(
            fmt::format("none of {} files holds results of `gloam check --json`", files.size()));
    std::optional<report::News> news;
    if (earlier) news = report::news_since(*earlier, all.summary);
    fmt::print("{}", report::to_summary_text(all.summary, news));
    lines.write(report::to_json_lines(all.summary));
    html.write(report::to_summary_page(all.summary, news, rejected));
    const bool failed = std::ranges::any_of(all.summary.groups(),
                                            [](const auto& group) { return group.second.failing() > 0; });
    return failed || !rejected.empty() ? 1 : 0;
}

}  // namespace gloam::cli
