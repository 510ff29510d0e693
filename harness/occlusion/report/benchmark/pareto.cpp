// SPDX-License-Identifier: MIT
#include "report/benchmark/pareto.hpp"
#include "numeric/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gloam::report {
namespace {

using numeric::infinity;

// Sums over a choice's scenes so far; geometric means are sums of logarithms.
struct Tally {
    Overall sums;
    std::size_t scenes = 0;

    void add(const Row& row, double least_error) {
        sums.copies += std::log(row.total_copies.median);
        sums.ms += std::log(row.total_ms.median);
        sums.error_ratio += std::log(row.quality.geometry / least_error);
        sums.mean_error += row.quality.geometry;
        sums.worst_copies = std::max(sums.worst_copies, row.total_copies.median);
        sums.worst_ms = std::max(sums.worst_ms, row.total_ms.median);
        sums.worst_error = std::max(sums.worst_error, row.quality.geometry);
        ++scenes;
    }

    [[nodiscard]] Overall mean() const {
        const auto count = static_cast<double>(scenes);
        Overall mean = sums;
        mean.copies = std::exp(sums.copies / count);
        mean.ms = std::exp(sums.ms / count);
        mean.error_ratio = std::exp(sums.error_ratio / count);
        mean.mean_error = sums.mean_error / count;
        return mean;
    }
};

bool is_known(const Row& row) {
    return std::isfinite(row.total_copies.median) && std::isfinite(row.quality.geometry);
}

std::map<std::string, double> least_errors(const Benchmark& benchmark) {
    std::map<std::string, double> least;
    for (const Row& row : benchmark.rows) {
        if (!is_known(row)) continue;
        const auto [at, fresh] = least.try_emplace(row.configuration.scene, infinity);
        at->second = std::min(at->second, row.quality.geometry);
    }
    return least;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].first) && std::isfinite(points[i].second)) order.push_back(i);
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    std::vector<std::size_t> front;
    double least = infinity;
    for (const std::size_t i : order) {
        if (!(points[i].second < least)) continue;
        least = points[i].second;
        front.push_back(i);
    }
    return front;
}

std::vector<std::string> scenes_of(const Benchmark& benchmark) {
    std::vector<std::string> scenes;
    for (const Row& row : benchmark.rows) {
        if (std::ranges::find(scenes, row.configuration.scene) == scenes.end())
            scenes.push_back(row.configuration.scene);
    }
    return scenes;
}

std::vector<const Row*> front_of(const Benchmark& benchmark, const std::string& scene) {
    std::vector<const Row*> rows;
    std::vector<std::pair<double, double>> points;
    for (const Row& row : benchmark.rows) {
        if (row.configuration.scene != scene) continue;
        rows.push_back(&row);
        points.emplace_back(row.total_copies.median, row.quality.geometry);
    }
    std::vector<const Row*> front;
    for (const std::size_t i : pareto_front(points)) front.push_back(rows[i]);
    return front;
}

std::vector<Overall> overall_of(const Benchmark& benchmark) {
    const std::map<std::string, double> least = least_errors(benchmark);
    std::vector<Tally> tallies;
    for (const Row& row : benchmark.rows) {
        if (!is_known(row)) continue;
        Configuration choice = row.configuration;
        choice.scene.clear();
        auto found = std::ranges::find(tallies, choice, [](const Tally& tally) { return tally.sums.choice; });
        if (found == tallies.end()) found = tallies.insert(found, Tally{.sums = {.choice = choice}});
        found->add(row, least.at(row.configuration.scene));
    }
    const std::size_t scenes = scenes_of(benchmark).size();
    std::vector<Overall> all;
    for (const Tally& tally : tallies)
        if (tally.scenes == scenes) all.push_back(tally.mean());
    return all;
}

std::vector<Overall> front_of(std::span<const Overall> choices) {
    std::vector<std::pair<double, double>> points;
    for (const Overall& choice : choices) points.emplace_back(choice.copies, choice.error_ratio);
    std::vector<Overall> front;
    for (const std::size_t i : pareto_front(points)) front.push_back(choices[i]);
    return front;
}

}  // namespace gloam::report
