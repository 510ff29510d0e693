// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "audit/mutant.hpp"
#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "base/threads.hpp"
#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "cli/framework/own_file.hpp"
#include "cli/progress.hpp"
#include "module/include.hpp"
#include "numeric/random.hpp"
#include "record/mutation_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t most_files = 20'000;

// Copies folders, files and links. What a compiler cannot read, for example a FIFO, is left out.
void copy_all(const fs::path& from, const fs::path& to) {
    std::uintmax_t bytes = 0;
    std::size_t files = 0;
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(from)) {
        const fs::path target = to / one.path().lexically_relative(from);
        const fs::file_type type = one.symlink_status().type();
        if (type == fs::file_type::regular) bytes += one.file_size();
        if (bytes > most_bytes || ++files > most_files)
            throw std::runtime_error(fmt::format(
                "{}: expected a folder of shaders to copy, found more than {} MiB or {} files; --include "
                "names another",
                from.string(), most_bytes >> 20, most_files));
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
        const auto read = module::include_closure({other.string(), module::read_text(other)},
                                                  include_roots_of(other, includes));
        return std::ranges::any_of(read, [&](const auto& one) { return fs::equivalent(one.path, file); });
    });
}

fs::path common_folder(const std::vector<fs::path>& files) {
    fs::path folder = files.front().parent_path();
    for (const fs::path& file : files)
        while (std::ranges::mismatch(folder, file).in1 != folder.end()) folder = folder.parent_path();
    return folder;
}

// What `gloam mutate` was asked.
struct MutateCommand {
    std::vector<std::string> paths;     // files, and folders of which all shaders count
    std::vector<std::string> includes;  // further include roots; the first is the folder that is copied
    std::vector<std::string> command;
    std::optional<std::size_t> count;  // of faults, one at each place; all without
    std::uint64_t seed = 1;
    std::size_t inputs = 4096;  // for each survivor
    std::optional<double> minutes;
    std::optional<double> patience;  // seconds
    unsigned jobs = 0;
    std::string known;
    std::string json;
};

// The faults of some files, and what becomes of each.
class Trials {
  public:
    // Reads the files and draws the faults. Throws for a file that cannot be read or compiled, and for a list
    // of known faults of another form.
    explicit Trials(const MutateCommand& command)
        : command_(command), jobs_(command.jobs == 0 ? base::processors() : command.jobs) {
        if (command.minutes)
            end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(60.0 * *command.minutes));
        report.command = fmt::format("{}", fmt::join(command.command, " "));
        read_known();
        read_files();
        draw();
    }

    // Runs everything that is left, until the time is over: first what the compiler decides. Throws
    // std::runtime_error if the command fails without a fault.
    void run() {
        const auto each = [&](const std::vector<std::size_t>& rows, const char* what, const auto& work) {
            base::for_each_index(
                rows.size(), jobs_,
                [&](std::size_t k) {
                    if (!is_over()) work(report.mutants[rows[k]]);
                },
                progress_bar(what));
        };
        each(all_of(Fate::untried), "compiled", [&](MutantRow& row) {
            const audit::Change change = files_[row.file].change_of(row.mutation);
            if (change == audit::Change::invalid) row.fate = Fate::invalid;
            if (change == audit::Change::same) row.fate = Fate::same;
            if (row.fate == Fate::untried && !(row.reason = known_reason(row)).empty())
                row.fate = Fate::known;
        });
        if (const auto left = all_of(Fate::untried); !left.empty() && !is_over()) {
            make_copies();
            run_unchanged(left);
            each(left, "tried", [&](MutantRow& row) { try_one(row); });
        }
        const std::vector<std::size_t> survived = all_of(Fate::survived);
        base::for_each_index(survived.size(), jobs_, [&](std::size_t k) {
            MutantRow& row = report.mutants[survived[k]];
            row.comparison = files_[row.file].compare(row.mutation, command_.inputs, command_.seed);
        });
    }

    record::MutationReport report;

  private:
    using Clock = std::chrono::steady_clock;

    void read_files() {
        std::vector<fs::path> real;
        std::vector<fs::path> named;
        for (const std::string& path : command_.paths)
            if (fs::exists(path)) named.push_back(fs::canonical(path));
        for (const fs::path& file : shaders_of(command_.paths)) {
            const std::string text = module::read_text(file);
            real.push_back(fs::canonical(file));
            const auto roots = include_roots_of(real.back(), command_.includes);
            files_.push_back(base::tried(file, [&] { return audit::MutantFile(real.back(), text, roots); }));
            report.files.push_back(file.string());
        }
        root_ = command_.includes.empty() ? common_folder(real) : fs::canonical(command_.includes.front());
        for (std::size_t i = 0; i < real.size(); ++i)
            if (std::ranges::mismatch(root_, real[i]).in1 != root_.end())
                throw std::runtime_error(fmt::format("{}: expected a file below --include {}",
                                                     report.files[i], command_.includes.front()));
        // Of folders all is taken: which file is read behind which is the engine's matter.
        for (const audit::MutantFile& file : files_)
            if (std::ranges::find(named, file.path()) != named.end() && !file.trouble().empty() &&
                !is_included(file.path(), root_, command_.includes))
                throw source::CompileError(file.trouble());
    }

    // All faults, or one at each of some places; by file and place, as the report has them.
    void draw() {
        std::map<std::pair<std::size_t, std::size_t>, std::vector<const source::Mutation*>> places;
        for (std::size_t file = 0; file < files_.size(); ++file)
            for (const source::Mutation& one : files_[file].mutations())
                places[{file, one.begin}].push_back(&one);
        if (places.empty()) throw std::runtime_error("the files have no place for a fault");
        numeric::Random random(command_.seed);
        std::vector<std::pair<std::uint64_t, MutantRow>> drawn;
        for (const auto& [place, faults] : places) {
            const std::uint64_t rank = random();
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
            order_.push_back(report.mutants.size());
            report.mutants.push_back(one.second);
        }
        std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return drawn[i].first; });
    }

    void read_known() {
        if (command_.known.empty()) return;
        std::istringstream lines(module::read_text(command_.known));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (source::trimmed(line).empty() || line.starts_with('#')) continue;
            const std::size_t first = line.find(" | ");
            const std::size_t last = line.rfind(" | ");
            if (first == std::string::npos || first == last)
                throw std::runtime_error(
                    fmt::format("{}:{}: expected FILE | LINE WITH THE FAULT | REASON, found {}",
                                command_.known, number, base::shortened(line, 80)));
            for (std::string& part : known_.emplace_back(std::array{
                     line.substr(0, first), line.substr(first + 3, last - first - 3), line.substr(last + 3)}))
                part = source::trimmed(part);
        }
    }

    [[nodiscard]] std::string known_reason(const MutantRow& row) const {
        const std::string text = source::mutated(files_[row.file].text(), row.mutation);
        const std::size_t first = text.substr(0, row.mutation.begin).rfind('\n') + 1;
        const std::size_t end = text.find('\n', row.mutation.begin + row.mutation.after.size());
        const std::string_view line = source::trimmed(std::string_view(text).substr(first, end - first));
        const std::string file = files_[row.file].path().generic_string();
        const auto found = std::ranges::find_if(
            known_, [&](const auto& one) { return one[1] == line && file.ends_with("/" + one[0]); });
        return found == known_.end() ? "" : (*found)[2];
    }

    [[nodiscard]] bool is_over() const { return Clock::now() > end_; }
    [[nodiscard]] std::vector<std::size_t> all_of(Fate fate) const {
        std::vector<std::size_t> rows;
        for (const std::size_t i : order_)
            if (report.mutants[i].fate == fate) rows.push_back(i);
        return rows;
    }

    void make_copies() {
        try {
            for (unsigned i = 0; i < jobs_; ++i) {
                free_.push_back(&copies_.emplace_back("mutate").path());
                copy_all(root_, *free_.back());
            }
        } catch (const fs::filesystem_error& error) {
            throw std::runtime_error(
                fmt::format("cannot copy {}: {}", root_.string(), error.code().message()));
        }
    }

    // Runs the command on a copy of the folder in which the file has this text.
    [[nodiscard]] base::ProcessResult run_with(std::size_t file, const std::string& text,
                                               std::chrono::milliseconds patience, double& seconds) {
        std::unique_lock lock(mutex_);
        const fs::path* const copy = free_.back();  // there are as many as threads
        free_.pop_back();
        lock.unlock();
        const fs::path name = files_[file].path().lexically_relative(root_);
        base::write_file(*copy / name, text);
        const auto begin = Clock::now();
        // For a program that is to read this copy, see module::read_text(); and which file has changed.
        base::ProcessResult result = base::run_process(
            command_.command,
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
    void run_unchanged(const std::vector<std::size_t>& left) {
        for (const std::size_t i : left) unchanged_[report.mutants[i].file] = 0.0;
        std::vector<std::pair<const std::size_t, double>*> files;
        for (auto& one : unchanged_) files.push_back(&one);
        base::for_each_index(files.size(), jobs_, [&](std::size_t k) {
            auto& [file, seconds] = *files[k];
            const auto result = run_with(file, files_[file].text(), std::chrono::hours(24), seconds);
            if (!result.succeeded())
                throw std::runtime_error(fmt::format("{}: the command {} without a fault; expected status 0",
                                                     report.files[file], result.how()));
        });
    }

    void try_one(MutantRow& row) {
        const double patience =
            command_.patience.value_or(least_patience + patience_factor * unchanged_.at(row.file));
        const base::ProcessResult result =
            run_with(row.file, source::mutated(files_[row.file].text(), row.mutation),
                     std::chrono::milliseconds(static_cast<long>(1000.0 * patience)), row.seconds);
        using End = base::ProcessResult::End;
        row.fate = result.succeeded()        ? Fate::survived
                   : result.end == End::time ? Fate::too_long
                                             : Fate::killed;
    }

    const MutateCommand& command_;
    unsigned jobs_;
    Clock::time_point end_ = Clock::time_point::max();
    std::deque<audit::MutantFile> files_;
    fs::path root_;                                  // that is copied
    std::deque<base::TemporaryFolder> copies_;       // one for each job
    std::vector<const fs::path*> free_;              // of these
    std::vector<std::size_t> order_;                 // of the mutants, as drawn
    std::map<std::size_t, double> unchanged_;        // seconds of the command without a fault, by file
    std::vector<std::array<std::string, 3>> known_;  // file, line, reason
    std::mutex mutex_;
};

int run_mutate(const MutateCommand& command) {
    if (command.command.empty())
        throw std::invalid_argument("mutate: expected -- COMMAND behind the files: what runs the tests");
    const record::OutputFile json(command.json);
    Trials trials(command);
    trials.run();
    fmt::print("{}", to_text(trials.report));
    if (!command.json.empty()) json.write(to_mutation_json(trials.report));
    if (trials.report.missed() > 0) return 1;
    return trials.report.is_begun() ? 0 : 2;
}

}  // namespace

Command mutate_command() {
    static MutateCommand command;
    return {
        .name = "mutate",
        .about = "plant faults in shaders, and show which of them a test does not notice",
        .options = {{"file", &command.paths, required, "GLSL files, and folders of them; -- COMMAND follows"},
                    {"--count", &command.count, between(1, 1e6),
                     "so many faults, one at each place (without: all)"},
                    {"--seed", &command.seed, "seed of the faults and the inputs"},
                    {"--inputs", &command.inputs, between(1, 1e6),
                     "inputs on which a survivor is compared with the original"},
                    {"--jobs", &command.jobs, between(1, 1024),
                     "commands at once (without: one for each processor)"},
                    {"--minutes", &command.minutes, between(0, 1e6), "begin nothing after so many minutes"},
                    {"--patience", &command.patience, between(0.1, 1e6),
                     "end a command after so many seconds (without: 5 s more than five times what it takes "
                     "without the fault)"},
                    include_option(command.includes),
                    {"--known", &command.known,
                     "file of faults that no test can notice: FILE | LINE WITH THE FAULT | REASON"},
                    {"--json", &command.json, "file for all results"}},
        .run = [] { return run_mutate(command); },
        .examples = R"(  gloam mutate shaders/tone.glsl -- ctest --test-dir build
  gloam mutate shaders --count 200 --seed 1 --json faults.json -- ./tests

COMMAND is run for each fault, without a shell. A status other than 0 means that it noticed the fault.
GLOAM_SHADERS names a copy of the folder of shaders (the first --include, otherwise that of the files) with
the fault, GLOAM_SHADERS_OF that folder, and GLOAM_SHADERS_CHANGED the changed file below it. gloam and tests
that use its framework read the copy by themselves.
)",
        .behind_dashes = &command.command};
}

}  // namespace gloam::cli
