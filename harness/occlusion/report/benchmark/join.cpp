// SPDX-License-Identifier: MIT
#include "report/benchmark/join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace gloam::report {
namespace {

auto circumstances_of_part(const Benchmark& part) {
    return std::tuple(part.width, part.height, part.frames, part.scored, part.rays);
}

void append_rows(Benchmark& whole, const Benchmark& part) {
    if (circumstances_of_part(whole) != circumstances_of_part(part)) {
        throw std::invalid_argument(fmt::format(
            "results of {} x {} pixels, {} frames, {} rays and of {} x {}, {}, {}: expected the same",
            whole.width, whole.height, whole.frames, whole.rays, part.width, part.height, part.frames,
            part.rays));
    }
    for (const Row& row : part.rows) {
        const auto same = [&](const Row& other) { return other.configuration == row.configuration; };
        if (std::ranges::any_of(whole.rows, same))
            throw std::invalid_argument(key_of(row.configuration) + ": in two results, expected in one");
        whole.rows.push_back(row);
    }
}

}  // namespace

Benchmark joined(std::span<const Benchmark> parts) {
    if (parts.empty()) throw std::invalid_argument("no results: expected one or more");
    const auto first = std::ranges::find_if(parts, [](const Benchmark& part) { return !part.rows.empty(); });
    Benchmark whole = first == parts.end() ? parts.front() : *first;
    whole.rows.clear();
    whole.framework.clear();
    for (const Benchmark& part : parts) {
        if (part.device != whole.device || part.driver != whole.driver) {
            throw std::invalid_argument(fmt::format("results of {} ({}) and of {} ({}): expected one device",
                                                    whole.device, whole.driver, part.device, part.driver));
        }
        if (!part.rows.empty()) append_rows(whole, part);
        whole.framework.insert(whole.framework.end(), part.framework.begin(), part.framework.end());
    }
    return whole;
}

}  // namespace gloam::report
