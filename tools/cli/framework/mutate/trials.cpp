// SPDX-License-Identifier: MIT
#include "cli/framework/mutate/trials.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/process.hpp"
#include "base/text.hpp"
#include "base/threads.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/progress.hpp"
#include "module/include.hpp"
#include "numeric/random.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t most_files = 20'000;

void require_small(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    std::size_t files = 0;
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(folder)) {
        ++files;
        std::error_code none;  // of a link in a loop
        if (one.symlink_status(none).type() == fs::file_type::regular) bytes += one.file_size();
        if (bytes > most_bytes || files > most_files)
            throw std::runtime_error(fmt::format(
                "{}: expected a folder of shaders to copy, found more than {} MiB or {} files; --include "
                "names another",
                folder.string(), most_bytes >> 20, most_files));
    }
}

// Copies folders, files and links. What a compiler cannot read, for example a FIFO, is left out.
void copy_all(const fs::path& from, const fs::path& to) {
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(from)) {
        const fs::path target = to / one.path().lexically_relative(from);
        const fs::file_type type = one.symlink_status().type();
        if (type == fs::file_type::directory) fs::create_directories(target);
        if (type == fs::file_type::regular) fs::copy_file(one.path(), target);
        if (type == fs::file_type::symlink) fs::copy_symlink(one.path(), target);
    }
}

using record::Fate;
using record::MutantRow;

constexpr double patience_factor = 5.0;  // of the time without a fault; other jobs run beside it
constexpr double least_patience = 5.0;   // seconds

// The files, in their order; of folders all shaders, sorted.
std::vector<fs::path> shaders_of(const std::vector<std::string>& paths) {
    std::vector<fs::path> files;
    for (const std::string& path : paths) {
        std::vector<fs::path> found{path};
        if (fs::is_directory(path)) {
            found.clear();
            for (const fs::directory_entry& one : fs::recursive_directory_iterator(path))
                if (std::error_code none; one.is_regular_file(none) && has_shader_ending(one.path().string()))
                    found.push_back(one.path());
            std::ranges::sort(found);
            if (found.empty()) throw std::runtime_error(path + ": a folder without shaders");
        }
        for (const fs::path& file : found)
            if (std::ranges::find(files, file) == files.end()) files.push_back(file);
    }
    return files;
}

// Whether a shader below the folder includes the file, at once or through others.
bool is_included(const fs::path& file, const fs::path& folder, const std::vector<std::string>& includes) {
    return std::ranges::any_of(shaders_of({folder.string()}), [&](const fs::path& other) {
        const auto read = shader::include_closure(shader::read_text(other), include_roots_of(other, includes),
                                                  other.parent_path());
        return std::ranges::any_of(read, [&](const auto& one) { return fs::equivalent(one.path, file); });
    });
}

fs::path common_folder(const std::vector<fs::path>& files) {
    fs::path folder = files.front().parent_path();
    for (const fs::path& file : files)
        while (std::ranges::mismatch(folder, file).in1 != folder.end()) folder = folder.parent_path();
    return folder;
}

// From the beginning of the line at `begin` to the end of the one at `end`, without blanks around it.
std::string lines_around(const std::string& text, std::size_t begin, std::size_t end) {
    const std::size_t first = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
    const std::string lines = text.substr(first, std::min(text.find('\n', end), text.size()) - first);
    const std::size_t start = lines.find_first_not_of(" \t\r\n");
    return start == std::string::npos ? ""
                                      : lines.substr(start, lines.find_last_not_of(" \t\r\n") - start + 1);
}

std::string trimmed(std::string text) {
    return lines_around(text, 0, text.size());
}

}  // namespace

Trials::Trials(const MutateCommand& command)
    : command_(command), jobs_(command.jobs == 0 ? base::processors() : command.jobs) {
    if (command.minutes)
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(60.0 * *command.minutes));
    report_.command = fmt::format("{}", fmt::join(command.command, " "));
    read_known();
    read_files();
    draw();
}

void Trials::read_files() {
    std::vector<fs::path> real;
    std::vector<fs::path> named;
    for (const std::string& path : command_.paths)
        if (fs::exists(path)) named.push_back(fs::canonical(path));
    for (const fs::path& file : shaders_of(command_.paths)) {
        const std::string text = shader::read_text(file);
        real.push_back(fs::canonical(file));
        const auto roots = include_roots_of(real.back(), command_.includes);
        base::try_compiler(file, [&] { const check::MutantFile tried(real.back(), text, roots); });
        files_.emplace_back(real.back(), text, roots);
        by_number_.push_back(&files_.back());
        report_.files.push_back(file.string());
    }
    root_ = command_.includes.empty() ? common_folder(real) : fs::canonical(command_.includes.front());
    for (std::size_t i = 0; i < real.size(); ++i)
        if (std::ranges::mismatch(root_, real[i]).in1 != root_.end())
            throw std::runtime_error(fmt::format("{}: expected a file below --include {}", report_.files[i],
                                                 command_.includes.front()));
    // Of folders all is taken: which file is read behind which is the engine's matter.
    for (const check::MutantFile& file : files_)
        if (std::ranges::find(named, file.path()) != named.end() && !file.trouble().empty() &&
            !is_included(file.path(), root_, command_.includes))
            throw shader::CompileError(file.trouble());
}

// All faults, or one at each of some places; by file and place, as the report has them.
void Trials::draw() {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<const shader::Mutation*>> places;
    for (std::size_t file = 0; file < by_number_.size(); ++file)
        for (const shader::Mutation& one : by_number_[file]->mutations())
            places[{file, one.begin}].push_back(&one);
    if (places.empty()) throw std::runtime_error("the files have no place for a fault");
    numeric::Random random(command_.seed);
    std::vector<std::pair<std::uint64_t, MutantRow>> drawn;
    for (const auto& [place, faults] : places) {
        const std::uint64_t rank = random.bits();
        const std::size_t chosen = random.below(faults.size());
        for (std::size_t i = 0; i < faults.size(); ++i)
            if (!command_.count || i == chosen)
                drawn.emplace_back(rank, MutantRow{.file = place.first, .mutation = *faults[i]});
    }
    if (command_.count && *command_.count < drawn.size()) {
        std::vector<std::uint64_t> ranks;
        for (const auto& one : drawn) ranks.push_back(one.first);
        std::ranges::sort(ranks);
        std::erase_if(drawn,
                      [limit = ranks[*command_.count]](const auto& one) { return one.first >= limit; });
    }
    for (const auto& one : drawn) {
        order_.push_back(report_.mutants.size());
        report_.mutants.push_back(one.second);
    }
    std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return drawn[i].first; });
}

void Trials::read_known() {
    if (command_.known.empty()) return;
    std::istringstream lines(shader::read_text(command_.known));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (trimmed(line).empty() || line.starts_with('#')) continue;
        const std::size_t first = line.find(" | ");
        const std::size_t last = line.rfind(" | ");
        if (first == std::string::npos || first == last)
            throw std::runtime_error(
                fmt::format("{}:{}: expected FILE | LINE WITH THE FAULT | REASON, found {}", command_.known,
                            number, base::shortened(line, 80)));
        known_.push_back({trimmed(line.substr(0, first)), trimmed(line.substr(first + 3, last - first - 3)),
                          trimmed(line.substr(last + 3))});
    }
}

std::string Trials::known_reason(const MutantRow& row) const {
    const std::string text = shader::mutated(by_number_[row.file]->text(), row.mutation);
    const std::size_t begin = row.mutation.begin;
    const std::string line = lines_around(text, begin, begin + row.mutation.after.size());
    const std::string file = by_number_[row.file]->path().generic_string();
    const auto found = std::ranges::find_if(
        known_, [&](const auto& one) { return one[1] == line && file.ends_with("/" + one[0]); });
    return found == known_.end() ? "" : (*found)[2];
}

std::vector<std::size_t> Trials::left() const {
    std::vector<std::size_t> rows;
    for (const std::size_t i : order_)
        if (report_.mutants[i].fate == Fate::untried) rows.push_back(i);
    return rows;
}

void Trials::compile(MutantRow& row) {
    const check::Change change = by_number_[row.file]->change_of(row.mutation);
    if (change == check::Change::invalid) row.fate = Fate::invalid;
    if (change == check::Change::same) row.fate = Fate::same;
    if (row.fate == Fate::untried && !(row.reason = known_reason(row)).empty()) row.fate = Fate::known;
}

void Trials::make_copies() {
    require_small(root_);
    try {
        for (unsigned i = 0; i < jobs_; ++i) {
            free_.push_back(&copies_.emplace_back("mutate").path());
            copy_all(root_, *free_.back());
        }
    } catch (const fs::filesystem_error& error) {
        throw std::runtime_error(fmt::format("cannot copy {}: {}", root_.string(), error.code().message()));
    }
}

base::ProcessResult Trials::run_with(std::size_t file, const std::string& text,
                                     std::chrono::milliseconds patience, double& seconds) {
    std::unique_lock lock(mutex_);
    const fs::path* const copy = free_.back();  // there are as many as threads
    free_.pop_back();
    lock.unlock();
    const fs::path name = by_number_[file]->path().lexically_relative(root_);
    base::write_file(*copy / name, text);
    const auto begin = Clock::now();
    // For a program that is to read this copy, see shader::overlaid(); and which file has changed.
    base::ProcessResult result = base::run_process(
        command_.command, "",
        {.patience = patience,
         .group = true,
         .environment = {"GLOAM_SHADERS=" + copy->string(), "GLOAM_SHADERS_OF=" + root_.string(),
                         "GLOAM_SHADERS_CHANGED=" + name.generic_string()}});
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    fs::copy_file(root_ / name, *copy / name, fs::copy_options::overwrite_existing);
    lock.lock();
    free_.push_back(copy);
    return result;
}

// The command must pass for each file without a fault. This also measures how long it takes.
void Trials::run_unchanged() {
    for (const std::size_t i : left()) unchanged_[report_.mutants[i].file] = 0.0;
    std::vector<std::pair<const std::size_t, double>*> files;
    for (auto& one : unchanged_) files.push_back(&one);
    base::for_each_index(files.size(), jobs_, [&](std::size_t k) {
        auto& [file, seconds] = *files[k];
        const auto result = run_with(file, by_number_[file]->text(), std::chrono::hours(24), seconds);
        if (!result.succeeded())
            throw std::runtime_error(fmt::format("{}: the command {} without a fault; expected status 0",
                                                 report_.files[file], result.how()));
    });
}

void Trials::try_one(MutantRow& row) {
    const double patience =
        command_.patience.value_or(least_patience + patience_factor * unchanged_.at(row.file));
    const base::ProcessResult result =
        run_with(row.file, shader::mutated(by_number_[row.file]->text(), row.mutation),
                 std::chrono::milliseconds(static_cast<long>(1000.0 * patience)), row.seconds);
    using End = base::ProcessResult::End;
    row.fate = result.succeeded() ? Fate::survived : result.end == End::time ? Fate::too_long : Fate::killed;
}

void Trials::run() {
    const auto each = [&](const std::vector<std::size_t>& rows, const char* what, const auto& work) {
        base::for_each_index(
            rows.size(), jobs_,
            [&](std::size_t k) {
                if (!is_over()) work(report_.mutants[rows[k]]);
            },
            progress_bar(what));
    };
    each(left(), "compiled", [&](MutantRow& row) { compile(row); });
    if (!left().empty() && !is_over()) {
        make_copies();
        run_unchanged();
        each(left(), "tried", [&](MutantRow& row) { try_one(row); });
    }
    std::vector<std::size_t> survived;
    for (const std::size_t i : order_)
        if (report_.mutants[i].fate == Fate::survived) survived.push_back(i);
    base::for_each_index(survived.size(), jobs_, [&](std::size_t k) {
        MutantRow& row = report_.mutants[survived[k]];
        row.comparison = by_number_[row.file]->compare(row.mutation, command_.inputs, command_.seed);
    });
}

}  // namespace gloam::cli
