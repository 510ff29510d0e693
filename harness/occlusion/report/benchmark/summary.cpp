// SPDX-License-Identifier: MIT
#include "report/benchmark/summary.hpp"

#include <algorithm>
#include <cmath>

namespace gloam::report {
namespace {

struct Sums {
    double gather = 0.0;
    double total = 0.0;
};

Sums sums_of(const Reading& reading) {
    Sums sums;
    for (const auto& [pass, ms] : reading.passes) {
        sums.total += ms;
        if (is_gather(pass)) sums.gather += ms;
    }
    return sums;
}

std::vector<double>& times_of(std::vector<std::pair<std::string, std::vector<double>>>& all,
                              const std::string& pass) {
    const auto found = std::ranges::find(all, pass, [](const auto& entry) { return entry.first; });
    return found != all.end() ? found->second : all.emplace_back(pass, std::vector<double>{}).second;
}

}  // namespace

bool is_gather(std::string_view pass) {
    return pass.starts_with("ambient_occlusion");
}

Row row_of(const Configuration& configuration, const Quality& quality, std::span<const Reading> readings) {
    Row row{.configuration = configuration, .quality = quality, .readings = readings.size()};
    std::vector<std::pair<std::string, std::vector<double>>> passes;
    std::vector<double> gather;
    std::vector<double> total;
    std::vector<double> gather_copies;
    std::vector<double> total_copies;
    for (const Reading& reading : readings) {
        for (const auto& [pass, ms] : reading.passes) times_of(passes, pass).push_back(ms);
        const Sums sums = sums_of(reading);
        gather.push_back(sums.gather);
        total.push_back(sums.total);
        gather_copies.push_back(sums.gather / reading.copy_ms);
        total_copies.push_back(sums.total / reading.copy_ms);
    }
    for (const auto& [pass, times] : passes) row.passes.emplace_back(pass, spread_of(times).median);
    row.gather_ms = spread_of(gather);
    row.total_ms = spread_of(total);
    row.gather_copies = spread_of(gather_copies);
    row.total_copies = spread_of(total_copies);
    return row;
}

}  // namespace gloam::report
