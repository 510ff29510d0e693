// SPDX-License-Identifier: MIT
#include "report/benchmark/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gloam::report {
namespace {

constexpr double noticed = 1e-4;  // RMSE: as many digits as are printed

const Row* find(const Benchmark& benchmark, const Configuration& configuration) {
    const auto found =
        std::ranges::find(benchmark.rows, configuration, [](const Row& row) { return row.configuration; });
    return found == benchmark.rows.end() ? nullptr : &*found;
}

Change change_of(const Row& before, const Row& after) {
    const Spread& old_time = before.total_copies;
    const Spread& new_time = after.total_copies;
    const double risen = after.quality.geometry - before.quality.geometry;
    return {.configuration = after.configuration,
            .time = {new_time.median / old_time.median, new_time.low / old_time.high,
                     new_time.high / old_time.low},
            .error = risen == 0.0 ? 1.0 : after.quality.geometry / before.quality.geometry,
            .slower = new_time.low > old_time.high,
            .faster = new_time.high < old_time.low,
            .worse = risen >= noticed,
            .better = risen <= -noticed};
}

double geometric_mean(const std::vector<Change>& changes, double (*of)(const Change&)) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Change& change : changes) {
        const double value = std::log(of(change));
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    return count == 0 ? 1.0 : std::exp(sum / static_cast<double>(count));
}

std::vector<std::string> warnings_of(const Benchmark& before, const Benchmark& after) {
    std::vector<std::string> warnings;
    if (before.device != after.device || before.driver != after.driver) {
        warnings.push_back(fmt::format("other devices: {} ({}) and {} ({}); times are compared in copies",
                                       before.device, before.driver, after.device, after.driver));
    }
    if (before.width != after.width || before.height != after.height) {
        warnings.push_back(fmt::format("other sizes: {}x{} and {}x{}", before.width, before.height,
                                       after.width, after.height));
    }
    if (before.frames != after.frames || before.scored != after.scored || before.rays != after.rays) {
        warnings.push_back(fmt::format("other frames or rays: {} of {} frames, {} rays and {} of {}, {}",
                                       before.scored, before.frames, before.rays, after.scored, after.frames,
                                       after.rays));
    }
    return warnings;
}

std::string line_of(const Change& change) {
    return fmt::format("  {:<44} time {:.3f} ({:.3f} to {:.3f})   error {:.3f}\n",
                       key_of(change.configuration), change.time.median, change.time.low, change.time.high,
                       change.error);
}

std::string list_of(const char* title, const std::vector<Change>& changes, bool Change::* which) {
    std::string lines;
    std::size_t count = 0;
    for (const Change& change : changes) {
        if (!(change.*which)) continue;
        lines += line_of(change);
        ++count;
    }
    return count == 0 ? std::string{} : fmt::format("{}: {}\n{}", title, count, lines);
}

std::string keys_line(const char* title, const std::vector<std::string>& keys) {
    return keys.empty() ? std::string{}
                        : fmt::format("{}: {}, the first {}\n", title, keys.size(), keys.front());
}

}  // namespace

bool Comparison::got_worse() const {
    return std::ranges::any_of(changes, [](const Change& c) { return c.slower || c.worse; });
}

Comparison compared(const Benchmark& before, const Benchmark& after) {
    Comparison result{.warnings = warnings_of(before, after)};
    for (const Row& row : after.rows) {
        if (const Row* old = find(before, row.configuration)) {
            result.changes.push_back(change_of(*old, row));
        } else {
            result.only_new.push_back(key_of(row.configuration));
        }
    }
    for (const Row& row : before.rows) {
        if (find(after, row.configuration) == nullptr) result.only_old.push_back(key_of(row.configuration));
    }
    result.time = geometric_mean(result.changes, [](const Change& c) { return c.time.median; });
    result.error = geometric_mean(result.changes, [](const Change& c) { return c.error; });
    return result;
}

std::string to_text(const Comparison& comparison) {
    std::string text;
    for (const std::string& warning : comparison.warnings) text += "warning: " + warning + "\n";
    text +=
        fmt::format("{} configurations in both; new over old, geometric means: time {:.3f}, error {:.3f}\n",
                    comparison.changes.size(), comparison.time, comparison.error);
    text += keys_line("only in the old file", comparison.only_old);
    text += keys_line("only in the new file", comparison.only_new);
    text += list_of("slower, beyond the spread", comparison.changes, &Change::slower);
    text += list_of("larger error", comparison.changes, &Change::worse);
    text += list_of("faster, beyond the spread", comparison.changes, &Change::faster);
    text += list_of("smaller error", comparison.changes, &Change::better);
    if (!comparison.got_worse()) text += "nothing got worse beyond the spread\n";
    return text;
}

}  // namespace gloam::report
