// SPDX-License-Identifier: MIT
#include "experiment/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

namespace gloam::experiment {
namespace {

using effect::Work;
using nlohmann::ordered_json;

// Quantities that are no times.
struct Quantity {
    std::string name;
    std::function<std::optional<double>(const Cell&)> of;
};

Quantity error(std::string name, double FrameQuality::* member) {
    return {std::move(name), [member](const Cell& cell) {
                return cell.quality ? std::optional(*cell.quality.*member) : std::nullopt;
            }};
}

// A count of tiles as a share of all.
Quantity tiles(std::string name, std::uint64_t Work::* member) {
    return {std::move(name), [member](const Cell& cell) -> std::optional<double> {
                if (cell.work.tiles == 0) return std::nullopt;
                return static_cast<double>(cell.work.*member) / static_cast<double>(cell.work.tiles);
            }};
}

// Pixels with a march that was ended, as a share of those with a surface.
std::optional<double> ended_early(const Cell& cell) {
    const Work& work = cell.work;
    if (work.tiles == 0) return std::nullopt;
    return static_cast<double>(work.ended_early) /
           static_cast<double>(std::max<std::uint64_t>(work.pixels - work.background, 1));
}

const std::vector<Quantity>& untimed() {
    static const std::vector<Quantity> all{
        error("rmse", &FrameQuality::geometry),
        error("rmse_raw", &FrameQuality::raw_geometry),
        error("rmse_depth", &FrameQuality::depth),
        error("rmse_depth_raw", &FrameQuality::raw_depth),
        error("bias", &FrameQuality::bias),
        error("similarity", &FrameQuality::similarity),
        error("samples", &FrameQuality::samples),
        {"memory_mib",
         [](const Cell& cell) {
             return cell.quality ? std::optional(static_cast<double>(cell.quality->memory_bytes) / 1048576.0)
                                 : std::nullopt;
         }},
        {"flicker", [](const Cell& cell) { return cell.quality ? cell.quality->flicker : std::nullopt; }},
        tiles("tiles_blank", &Work::tiles_blank),
        tiles("tiles_open", &Work::tiles_open),
        tiles("tiles_settled", &Work::tiles_settled),
        tiles("tiles_filtered", &Work::tiles_filtered),
        tiles("tiles_unfiltered", &Work::tiles_unfiltered),
        {"ended_early", ended_early},
        {"difference", [](const Cell& cell) { return cell.difference; }},
        {"rmse_own_radius", [](const Cell& cell) { return cell.own_radius_error; }},
        {"rmse_remapped",
         [](const Cell& cell) { return cell.quality ? cell.quality->remapped : std::nullopt; }},
        {"samples_asked",
         [](const Cell& cell) { return std::optional(static_cast<double>(cell.samples_asked)); }}};
    return all;
}

bool counts(const TimedPasses& passes, const std::string& name) {
    if (!passes.name.empty()) return name == passes.name;
    return passes.prefixes.empty() || std::ranges::any_of(passes.prefixes, [&](const std::string& prefix) {
               return name.starts_with(prefix);
           });
}

double sum_of(const FrameReading& reading, const TimedPasses& passes) {
    double sum = 0.0;
    for (const effect::PassTime& time : reading.passes)
        if (counts(passes, time.pass)) sum += time.ms;
    return sum;
}

// The time of a cell, in milliseconds or in copies. nullopt without readings.
std::optional<double> time_of(const Cell& cell, bool copies, std::string_view statistic,
                              const TimedPasses& passes) {
    const std::vector<double> times = times_of(cell, copies, passes);
    if (times.empty()) return std::nullopt;
    return statistic == "least" ? *std::ranges::min_element(times) : numeric::spread_of(times).median;
}

std::optional<double> value_of(const Cell& cell, std::string_view quantity, std::string_view statistic,
                               const TimedPasses& passes) {
    if (quantity == "ms" || quantity == "copies")
        return time_of(cell, quantity == "copies", statistic, passes);
    const auto found = std::ranges::find(untimed(), quantity, &Quantity::name);
    return found == untimed().end() ? std::nullopt : found->of(cell);
}

double median_of_round(const std::vector<FrameReading>& round, const TimedPasses& passes) {
    std::vector<double> times;
    for (const FrameReading& reading : round) times.push_back(sum_of(reading, passes));
    return numeric::spread_of(times).median;
}

// For a quoted field of CSV.
std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
    return text;
}

ordered_json json_of(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json json_of(const Cell& cell, const std::string& candidate) {
    ordered_json json{{"candidate", candidate}};
    for (const Quantity& quantity : untimed()) json[quantity.name] = json_of(quantity.of(cell));
    if (cell.quality) json["memory_bytes"] = cell.quality->memory_bytes;
    json["ms"] = json_of(time_of(cell, false, "median", {}));
    json["copies"] = json_of(time_of(cell, true, "median", {}));
    json["passes"] = ordered_json::array();
    for (const std::string& pass : passes_of(cell))
        json["passes"].push_back({{"pass", pass},
                                  {"ms", json_of(time_of(cell, false, "median", {.name = pass}))},
                                  {"least_ms", json_of(time_of(cell, false, "least", {.name = pass}))},
                                  {"copies", json_of(time_of(cell, true, "median", {.name = pass}))}});
    ordered_json rounds = ordered_json::array();
    for (const std::vector<FrameReading>& round : cell.rounds)
        if (!round.empty()) rounds.push_back(median_of_round(round, {}));
    json["rounds_ms"] = rounds;
    return json;
}

ordered_json json_of(const Experiment& experiment, const CaseResult& one) {
    ordered_json json{{"case", one.shown.name}};
    for (const auto& [name, text] :
         {std::pair("what", &one.shown.what), {"kind", &one.shown.kind}, {"half", &one.shown.half}})
        if (!text->empty()) json[name] = *text;
    if (one.shown.value > 0.0) json["value"] = one.shown.value;
    if (one.shown.target > 0.0) json["target"] = one.shown.target;
    json["results"] = ordered_json::array();
    for (std::size_t i = 0; i < one.cells.size(); ++i)
        if (one.cells[i]) json["results"].push_back(json_of(*one.cells[i], experiment.candidates[i].name));
    return json;
}

std::optional<double> value_in(const CaseResult& one, std::size_t candidate, std::string_view quantity,
                               std::string_view statistic, const TimedPasses& passes) {
    const std::optional<Cell>& cell = one.cells.at(candidate);
    return cell ? value_of(*cell, quantity, statistic, passes) : std::nullopt;
}

// The ratio to the least value of any candidate.
std::optional<double> ratio_to_best(const CaseResult& one, std::size_t candidate, std::string_view quantity,
                                    const TimedPasses& passes) {
    const auto own = value_in(one, candidate, quantity, "median", passes);
    std::optional<double> least;
    for (std::size_t i = 0; i < one.cells.size(); ++i)
        if (const auto value = value_in(one, i, quantity, "median", passes))
            least = std::min(least.value_or(*value), *value);
    return own && least ? std::optional(*own / *least) : std::nullopt;
}

// Of value ~ growing^e, by least squares on logarithmic axes. nullopt without two cases that differ.
std::optional<double> exponent_of(const std::vector<const CaseResult*>& cases, std::size_t candidate,
                                  std::string_view quantity, const TimedPasses& passes) {
    std::vector<std::pair<double, double>> points;
    for (const CaseResult* one : cases)
        if (const auto value = mean_value({one}, candidate, quantity, "median", passes))
            points.emplace_back(one->shown.value, *value);
    const double exponent = numeric::exponent_of(points);
    return std::isfinite(exponent) ? std::optional(exponent) : std::nullopt;
}

}  // namespace

const std::vector<std::string>& quantities() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"ms", "copies"};
        for (const Quantity& quantity : untimed()) all.push_back(quantity.name);
        return all;
    }();
    return names;
}

std::string size_text(gpu::Extent extent) {
    return fmt::format("{} x {}", extent.width, extent.height);
}

std::vector<double> times_of(const Cell& cell, bool copies, const TimedPasses& passes) {
    std::vector<double> times;
    for (const std::vector<FrameReading>& round : cell.rounds)
        for (const FrameReading& reading : round)
            times.push_back(sum_of(reading, passes) / (copies ? reading.copy_ms : 1.0));
    return times;
}

std::vector<std::string> passes_of(const Cell& cell) {
    std::vector<std::string> names;
    for (const std::vector<FrameReading>& round : cell.rounds)
        for (const FrameReading& reading : round)
            for (const effect::PassTime& time : reading.passes)
                if (std::ranges::count(names, time.pass) == 0) names.push_back(time.pass);
    return names;
}

std::optional<double> mean_value(const std::vector<const CaseResult*>& cases, std::size_t candidate,
                                 std::string_view quantity, std::string_view statistic,
                                 const TimedPasses& passes) {
    if (statistic == "exponent") return exponent_of(cases, candidate, quantity, passes);
    const bool of_best = statistic == "of_best";
    const bool geometric = quantity == "ms" || quantity == "copies" || of_best;
    double sum = 0.0;
    double most = -numeric::infinity;
    for (const CaseResult* one : cases) {
        const auto value = of_best ? ratio_to_best(*one, candidate, quantity, passes)
                                   : value_in(*one, candidate, quantity, statistic, passes);
        if (!value) return std::nullopt;
        if (cases.size() == 1) return value;
        sum += geometric ? std::log(*value) : *value;
        most = std::max(most, *value);
    }
    if (cases.empty()) return std::nullopt;
    if (statistic == "most") return most;
    const double mean = sum / static_cast<double>(cases.size());
    return geometric ? std::exp(mean) : mean;
}

std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].first) && std::isfinite(points[i].second)) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i]; });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || points[i].second < points[front.back()].second) front.push_back(i);
    return front;
}

std::vector<FrontPoint> front_points(const std::vector<const CaseResult*>& cases) {
    const char* statistic = cases.size() > 1 ? "of_best" : "median";
    std::vector<FrontPoint> points;
    for (std::size_t i = 0; !cases.empty() && i < cases.front()->cells.size(); ++i) {
        const auto copies = mean_value(cases, i, "copies", "median", {});
        const auto error = mean_value(cases, i, "rmse", statistic, {});
        if (copies && error) points.push_back({i, *copies, *error});
    }
    return points;
}

std::vector<FrontPoint> front_of(const std::vector<FrontPoint>& points) {
    std::vector<std::pair<double, double>> pairs;
    for (const FrontPoint& point : points) pairs.emplace_back(point.copies, point.error);
    std::vector<FrontPoint> front;
    for (const std::size_t i : pareto_front(pairs)) front.push_back(points[i]);
    return front;
}

numeric::Spread round_ratios(const CaseResult& one, std::size_t of, std::size_t over,
                             const TimedPasses& passes, const TimedPasses& over_passes) {
    std::vector<double> ratios;
    const std::optional<Cell>& a = one.cells.at(of);
    const std::optional<Cell>& b = one.cells.at(over);
    for (std::size_t i = 0; a && b && i < std::min(a->rounds.size(), b->rounds.size()); ++i)
        ratios.push_back(median_of_round(a->rounds[i], passes) / median_of_round(b->rounds[i], over_passes));
    return numeric::spread_of(ratios);
}

std::vector<Growth> growths(const Experiment& experiment, const SizeResult& result) {
    std::vector<Growth> all;
    for (const CaseResult& one : result.cases) {
        for (std::size_t i = 0; one.shown.value > 0.0 && i < one.cells.size(); ++i) {
            const auto ms = mean_value({&one}, i, "ms", "median", {});
            if (!ms) continue;
            const std::string& candidate = experiment.candidates[i].name;
            auto found = std::ranges::find_if(all, [&](const Growth& growth) {
                return growth.kind == one.shown.kind && growth.candidate == candidate;
            });
            if (found == all.end()) found = all.insert(found, Growth{one.shown.kind, candidate, {}});
            found->points.emplace_back(one.shown.value, *ms);
        }
    }
    return all;
}

double copy_ms(const SizeResult& result) {
    std::vector<double> times;
    for (const CaseResult& one : result.cases)
        for (const std::optional<Cell>& cell : one.cells)
            for (std::size_t i = 0; cell && i < cell->rounds.size(); ++i)
                for (const FrameReading& reading : cell->rounds[i]) times.push_back(reading.copy_ms);
    return numeric::spread_of(times).median;
}

std::string to_json(const Experiment& experiment, const std::vector<SizeResult>& results,
                    const Record& record, const std::string& versions) {
    ordered_json document{{"versions", versions}};
    document.update(ordered_json::parse(record.heading()));
    document["sizes"] = ordered_json::array();
    for (const SizeResult& result : results) {
        ordered_json size{{"width", result.extent.width},
                          {"height", result.extent.height},
                          {"copy_ms", json_of(copy_ms(result))},
                          {"cases", ordered_json::array()}};
        for (const CaseResult& one : result.cases) size["cases"].push_back(json_of(experiment, one));
        document["sizes"].push_back(std::move(size));
    }
    document["visits"] = ordered_json::array();
    for (const Visit& visit : record.visits())
        document["visits"].push_back(ordered_json::parse(line_of(visit)));
    return document.dump(1) + "\n";
}

std::string to_csv(const Experiment& experiment, const std::vector<SizeResult>& results) {
    std::string text = fmt::format("width,height,case,what,candidate,{}\n", fmt::join(quantities(), ","));
    for (const SizeResult& result : results) {
        for (const CaseResult& one : result.cases) {
            for (std::size_t i = 0; i < one.cells.size(); ++i) {
                if (!one.cells[i]) continue;
                text += fmt::format("{},{},\"{}\",\"{}\",\"{}\"", result.extent.width, result.extent.height,
                                    quoted(one.shown.name), quoted(one.shown.what),
                                    quoted(experiment.candidates[i].name));
                for (const std::string& quantity : quantities()) {
                    const auto value = value_of(*one.cells[i], quantity, "median", {});
                    text += value && std::isfinite(*value) ? fmt::format(",{}", *value) : ",";
                }
                text += "\n";
            }
        }
    }
    return text;
}

}  // namespace gloam::experiment
