// SPDX-License-Identifier: MIT
// `gloam work`: one list of calls of gloam, run by many machines.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdlib>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "base/cached_file.hpp"
#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/check/worker_session.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/work_list.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
using base::ProcessResult;

constexpr std::size_t key_length = 32;

ProcessResult run_gloam(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "/proc/self/exe");
    return base::run_process(arguments, "", {.patience = std::chrono::hours(24 * 365)});
}

// What an item's result depends on besides the item: the devices here, and the files that the item names.
class Here {
  public:
    std::string key_of(const WorkItem& item) {
        std::vector<std::string> drivers;
        base::Fingerprint key;
        for (std::size_t i = 0; i < item.size(); ++i) {
            if (i > 0 && item[i - 1] == "--driver") drivers.insert(drivers.end(), {"--driver", item[i]});
            std::error_code none;
            if (fs::is_regular_file(item[i], none)) key.add(base::read_file(item[i]));
        }
        key.add(devices(drivers));
        return base::to_hex(key.hash());
    }

  private:
    // The names, drivers and versions of the devices; empty if there are none.
    const std::string& devices(const std::vector<std::string>& drivers) {
        const auto [known, is_new] = devices_.try_emplace(drivers);
        if (!is_new) return known->second;
        std::vector<std::string> arguments{"devices", "--json"};
        arguments.insert(arguments.end(), drivers.begin(), drivers.end());
        const auto all = nlohmann::json::parse(run_gloam(arguments).output, nullptr, false);
        if (all.is_object())
            for (const auto& device : all.value("devices", nlohmann::json::array()))
                known->second += fmt::format("{}\n{}\n{}\n", device.value("name", ""),
                                             device.value("driver", ""), device.value("api_version", ""));
        return known->second;
    }

    std::map<std::vector<std::string>, std::string> devices_;
};

// A hidden folder beside the results, for one call; removed with what it holds.
class Scratch {
  public:
    Scratch(const fs::path& results, const std::string& name) {
        std::string path = (results / ("." + name + "-XXXXXX")).string();
        if (::mkdtemp(path.data()) == nullptr) base::fail_to_write(results, errno);
        folder_ = path;
    }
    ~Scratch() {
        std::error_code remains;
        fs::remove_all(folder_, remains);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] fs::path result() const { return folder_ / "result"; }

  private:
    fs::path folder_;
};

enum class Became { known, done, lost };

// Runs an item whose result is not there. The result appears complete or not at all.
Became run_item(const WorkItem& item, std::size_t index, const fs::path& results, Here& here) {
    const std::string name = WorkList::key_of(item) + "-" + here.key_of(item);
    const fs::path file = results / (name + ".json");
    const fs::path folder = results / name;
    if (fs::exists(file) || fs::exists(folder)) return Became::known;
    const Scratch scratch(results, name);
    const ProcessResult result = run_gloam(with_result(item, scratch.result().string()));
    if (result.end != ProcessResult::End::status || !fs::exists(scratch.result())) {
        fmt::print(stderr, "gloam: item {} (gloam {}) has no result: it {}\n", index,
                   base::one_line(fmt::format("{}", fmt::join(item, " "))), base::one_line(result.how()));
        return Became::lost;
    }
    std::error_code error;
    const fs::path& target = fs::is_directory(scratch.result()) ? folder : file;
    fs::rename(scratch.result(), target, error);
    if (error && !fs::exists(target)) base::fail_to_write(target, error.value());
    return Became::done;
}

struct WorkOptions {
    std::vector<std::string> each;
    WorkItem arguments;
    fs::path list;
    fs::path results;
    std::string shard;
    std::size_t shards = 0;
};

int run_work(const WorkOptions& options) {
    const WorkList list = read_work_list(options.list);
    const Shard shard = shard_from(options.shard);
    fs::create_directories(options.results);
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (shard.holds(i)) mine.push_back(i);
    Here here;
    ProgressLine progress("items", mine.size());
    std::map<Became, std::size_t> count;
    for (const std::size_t i : mine) {
        progress.show();
        const Became became = run_item(list.items[i], i, options.results, here);
        ++count[became];
        progress.step(became == Became::known);
    }
    progress.wipe();
    fmt::print("{} items of {}: {} done, {} were there, {} have no result\n", mine.size(), list.items.size(),
               count[Became::done], count[Became::known], count[Became::lost]);
    return count[Became::lost] == 0 ? 0 : 2;
}

// "3,7-9": as the options of job arrays have it.
std::string ranges_of(const std::set<std::size_t>& numbers) {
    std::string text;
    for (auto each = numbers.begin(); each != numbers.end();) {
        const std::size_t first = *each;
        std::size_t last = first;
        while (++each != numbers.end() && *each == last + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(first);
        if (last > first) text += "-" + std::to_string(last);
    }
    return text;
}

void print_missing(const WorkOptions& options) {
    const WorkList list = read_work_list(options.list);
    std::set<std::string> known;
    if (fs::exists(options.results))
        for (const fs::directory_entry& entry : fs::directory_iterator(options.results))
            known.insert(entry.path().filename().string().substr(0, key_length));
    const std::size_t shards = options.shards == 0 ? list.items.size() : options.shards;
    std::set<std::size_t> missing;
    std::size_t items = 0;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        if (known.contains(WorkList::key_of(list.items[i]))) continue;
        missing.insert(i % shards);
        ++items;
    }
    fmt::print(stderr, "{} of {} items have no result\n", items, list.items.size());
    if (!missing.empty()) fmt::print("{}\n", ranges_of(missing));
}

void add_place(CLI::App& command, WorkOptions& options) {
    command.add_option("list", options.list, "what `gloam work list` printed")->required();
    command.add_option("--results", options.results, "folder of the results, which all machines share")
        ->required();
}

}  // namespace

void add_work(CLI::App& app, int& status) {
    auto options = std::make_shared<WorkOptions>();
    CLI::App* work = app.add_subcommand("work", "one list of work, run by many machines");
    work->require_subcommand(1);
    CLI::App* list =
        work->add_subcommand("list", "print a list: one call of gloam for each combination of values");
    list->add_option(
            "--each", options->each,
            "NAME=VALUES: what {NAME} stands for: LOW..HIGH, texts between commas, or @FILE, a text a line")
        ->allow_extra_args(false);
    list->add_option("arguments", options->arguments,
                     "-- and the arguments of gloam, with {result} for what the call writes")
        ->required();
    list->callback([options] { fmt::print("{}", to_text(work_list_of(options->each, options->arguments))); });
    CLI::App* run = work->add_subcommand("run", "run the items that have no result");
    add_place(*run, *options);
    run->add_option("--shard", options->shard, "INDEX/COUNT: run only every COUNTth item, counted from 0");
    run->callback([options, &status] { status = run_work(*options); });
    CLI::App* missing =
        work->add_subcommand("missing", "print which shards have items without a result: 3,7-9");
    add_place(*missing, *options);
    missing
        ->add_option("--shards", options->shards,
                     "COUNT of `gloam work run --shard` (default: one for each item)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
    missing->callback([options] { print_missing(*options); });
}

}  // namespace gloam::cli
