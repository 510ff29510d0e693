// SPDX-License-Identifier: MIT
#include "experiment/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "experiment/internal/quantities.hpp"

namespace gloam::experiment {
namespace {

using effect::Work;
using internal::Quantity;
using internal::value_of;

// Those of scores by class alone.
constexpr std::array<std::string_view, 4> class_only{"bias_raw", "samples_so_far", "rmse_independent",
                                                     "share"};

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

Quantity converged(std::string name, std::optional<double> (*of)(const Converged&)) {
    return {std::move(name), [of](const Cell& cell) {
                return cell.quality && cell.quality->converged ? of(*cell.quality->converged) : std::nullopt;
            }};
}

Quantity point(std::string name, std::optional<double> (*of)(const PointQuality&)) {
    return {std::move(name), [of](const Cell& cell) { return cell.point ? of(*cell.point) : std::nullopt; }};
}

std::optional<double> rmse_of(const std::optional<effect::Errors>& errors) {
    return errors ? std::optional(errors->rmse) : std::nullopt;
}

bool counts(const Part& passes, const std::string& name) {
    if (!passes.name.empty()) return name == passes.name;
    return passes.prefixes.empty() || std::ranges::any_of(passes.prefixes, [&](const std::string& prefix) {
               return name.starts_with(prefix);
           });
}

double sum_of(const FrameReading& reading, const Part& passes) {
    double sum = 0.0;
    for (const effect::PassTime& time : reading.passes)
        if (counts(passes, time.pass)) sum += time.ms;
    return sum;
}

// The time of a cell, in milliseconds. nullopt without readings.
std::optional<double> time_of(const Cell& cell, std::string_view statistic, const Part& passes) {
    const std::vector<double> times = times_of(cell, passes);
    if (times.empty()) return std::nullopt;
    return statistic == "least" ? *std::ranges::min_element(times) : numeric::spread_of(times).median;
}

// The last frame up to part.frame; all of them with 0.
std::span<const FrameScore> frames_of(const ClassScores& scores, const Part& part) {
    const std::span all(scores.frames);
    if (part.frame == 0) return all;
    const auto later =
        std::ranges::find_if(all, [&](const FrameScore& one) { return one.frame > part.frame; });
    const auto end = static_cast<std::size_t>(later - all.begin());
    return all.subspan(end == 0 ? 0 : end - 1, end == 0 ? 0 : 1);
}

// The scores of one class against one reference, over the frames that count.
ClassScore sum_of(const ClassScores& scores, const std::string& pixels, const Part& part) {
    const std::string against = part.against.empty() ? "geometry" : part.against;
    ClassScore sum;
    for (const FrameScore& frame : frames_of(scores, part)) {
        for (const ClassScore& score : frame.classes) {
            if (score.pixels != pixels || score.against != against) continue;
            sum.count += score.count;
            sum.squares += score.squares;
            sum.raw_squares += score.raw_squares;
            sum.raw_errors += score.raw_errors;
        }
    }
    return sum;
}

// Samples that a pixel has taken up to the last frame that counts.
double samples_in(const ClassScores& scores, const Part& part) {
    const std::span<const FrameScore> frames = frames_of(scores, part);
    return frames.empty() ? 0.0 : frames.back().samples;
}

// A quantity of one class against one reference, over the scored frames or in one of them.
std::optional<double> class_value(const ClassScores& scores, std::string_view quantity, const Part& part) {
    const std::string pixels = part.pixels.empty() ? "all" : part.pixels;
    if (quantity == "flicker") {
        const auto found = std::ranges::find(scores.flicker, pixels, &ClassFlicker::pixels);
        return found == scores.flicker.end() ? std::nullopt : std::optional(found->mean);
    }
    if (quantity == "samples_so_far" && !scores.frames.empty()) return samples_in(scores, part);
    const ClassScore sum = sum_of(scores, pixels, part);
    if (quantity == "share") {
        const double all = sum_of(scores, "all", part).squares;
        return all > 0.0 ? std::optional(sum.squares / all) : std::nullopt;
    }
    if (sum.count == 0) return std::nullopt;
    const auto count = static_cast<double>(sum.count);
    if (quantity == "bias_raw") return sum.raw_errors / count;
    if (quantity == "rmse") return std::sqrt(sum.squares / count);
    if (quantity == "rmse_raw") return std::sqrt(sum.raw_squares / count);
    Part first = part;  // what independent samples would have made of its error
    first.frame = scores.frames.front().frame;
    const auto raw = class_value(scores, "rmse_raw", first);
    return raw ? std::optional(*raw * std::sqrt(scores.frames.front().samples / samples_in(scores, part)))
               : std::nullopt;
}

std::optional<double> slope_of(const ClassScores& scores, std::string_view quantity, Part part) {
    std::vector<std::pair<double, double>> points;
    for (const FrameScore& frame : scores.frames) {
        if (frame.samples >= scores.most_samples) continue;
        part.frame = frame.frame;
        if (const auto error = class_value(scores, quantity, part))
            points.emplace_back(frame.samples, *error * *error);
    }
    const double slope = numeric::exponent_of(points);
    return std::isfinite(slope) ? std::optional(slope) : std::nullopt;
}

bool is_class_only(std::string_view quantity) {
    return std::ranges::find(class_only, quantity) != class_only.end();
}

}  // namespace

namespace internal {

const std::vector<Quantity>& untimed() {
    static const std::vector<Quantity> all{
        error("rmse", &FrameQuality::geometry),
        error("rmse_raw", &FrameQuality::raw_geometry),
        error("rmse_depth", &FrameQuality::depth),
        error("rmse_depth_raw", &FrameQuality::raw_depth),
        error("bias", &FrameQuality::bias),
        {"percentile_99",
         [](const Cell& cell) { return cell.quality ? cell.quality->percentile_99 : std::nullopt; }},
        {"rmse_fit", [](const Cell& cell) { return cell.rmse_fit; }},
        error("similarity", &FrameQuality::similarity),
        error("samples", &FrameQuality::samples),
        {"memory_mib",
         [](const Cell& cell) {
             return cell.quality ? std::optional(static_cast<double>(cell.quality->memory_bytes) / 1048576.0)
                                 : std::nullopt;
         }},
        {"flicker", [](const Cell& cell) { return cell.quality ? cell.quality->flicker : std::nullopt; }},
        tiles("tiles_blank", &Work::tiles_blank),
        tiles("tiles_settled", &Work::tiles_settled),
        tiles("tiles_filtered", &Work::tiles_filtered),
        tiles("tiles_unfiltered", &Work::tiles_unfiltered),
        {"rmse_own_radius", [](const Cell& cell) { return cell.own_radius_error; }},
        {"rmse_remapped",
         [](const Cell& cell) { return cell.quality ? cell.quality->remapped : std::nullopt; }},
        {"samples_asked",
         [](const Cell& cell) {
             return cell.samples_asked > 0 ? std::optional(static_cast<double>(cell.samples_asked))
                                           : std::nullopt;
         }},
        converged("converged_rmse", [](const Converged& all) { return std::optional(all.geometry.rmse); }),
        converged("converged_bias", [](const Converged& all) { return std::optional(all.geometry.bias); }),
        converged("converged_remapped",
                  [](const Converged& all) { return std::optional(all.remapped.rmse); }),
        converged("converged_similarity", [](const Converged& all) { return std::optional(all.similarity); }),
        converged("converged_depth", [](const Converged& all) { return rmse_of(all.depth); }),
        converged("converged_own", [](const Converged& all) { return rmse_of(all.own); }),
        point("truth", [](const PointQuality& all) { return std::optional(all.truth); }),
        point("occlusion", [](const PointQuality& all) { return std::optional(all.occlusion); }),
        point("shown", [](const PointQuality& all) { return all.shown; }),
        point("off_truth", [](const PointQuality& all) {
            return all.shown ? std::optional(*all.shown - all.truth) : std::nullopt;
        })};
    return all;
}

std::optional<double> value_of(const Cell& cell, std::string_view quantity, std::string_view statistic,
                               const Part& passes) {
    const bool part = !passes.pixels.empty() || !passes.against.empty() || passes.frame > 0;
    if (part || statistic == "slope" || is_class_only(quantity)) {
        if (!cell.quality || !cell.quality->by_class) return std::nullopt;
        const ClassScores& scores = *cell.quality->by_class;
        return statistic == "slope" ? slope_of(scores, quantity, passes)
                                    : class_value(scores, quantity, passes);
    }
    if (quantity == "ms") return time_of(cell, statistic, passes);
    const auto found = std::ranges::find(untimed(), quantity, &Quantity::name);
    return found == untimed().end() ? std::nullopt : found->of(cell);
}

double median_of_round(const std::vector<FrameReading>& round, const Part& passes) {
    std::vector<double> times;
    for (const FrameReading& reading : round) times.push_back(sum_of(reading, passes));
    return numeric::spread_of(times).median;
}

}  // namespace internal

namespace {

std::optional<double> value_in(const CaseResult& one, std::size_t candidate, std::string_view quantity,
                               std::string_view statistic, const Part& passes) {
    const std::optional<Cell>& cell = one.cells.at(candidate);
    return cell ? value_of(*cell, quantity, statistic, passes) : std::nullopt;
}

// The ratio to the least value of any candidate.
std::optional<double> ratio_to_best(const CaseResult& one, std::size_t candidate, std::string_view quantity,
                                    const Part& passes) {
    const auto own = value_in(one, candidate, quantity, "median", passes);
    std::optional<double> least;
    for (std::size_t i = 0; i < one.cells.size(); ++i)
        if (const auto value = value_in(one, i, quantity, "median", passes))
            least = std::min(least.value_or(*value), *value);
    return own && least ? std::optional(*own / *least) : std::nullopt;
}

}  // namespace

const std::vector<std::string>& quantities() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"ms"};
        for (const Quantity& quantity : internal::untimed()) all.push_back(quantity.name);
        return all;
    }();
    return names;
}

const std::vector<std::string>& class_quantities() {
    static const std::vector<std::string> names{"rmse",           "rmse_raw",         "flicker", "bias_raw",
                                                "samples_so_far", "rmse_independent", "share"};
    return names;
}

bool by_class(const Column& column) {
    return !column.pixels.empty() || !column.against.empty() || column.frame > 0 || column.over_frame > 0 ||
           column.statistic == "slope" || is_class_only(column.value);
}

std::string size_text(gpu::Extent extent) {
    return fmt::format("{} x {}", extent.width, extent.height);
}

std::vector<double> times_of(const Cell& cell, const Part& passes) {
    std::vector<double> times;
    for (const std::vector<FrameReading>& round : cell.rounds)
        for (const FrameReading& reading : round) times.push_back(sum_of(reading, passes));
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
                                 std::string_view quantity, std::string_view statistic, const Part& passes) {
    const bool of_best = statistic == "of_best";
    const bool geometric = quantity == "ms" || of_best;
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
        const auto ms = mean_value(cases, i, "ms", "median", {});
        const auto error = mean_value(cases, i, "rmse", statistic, {});
        if (ms && error) points.push_back({i, *ms, *error});
    }
    return points;
}

std::vector<FrontPoint> front_of(const std::vector<FrontPoint>& points) {
    std::vector<std::pair<double, double>> pairs;
    for (const FrontPoint& point : points) pairs.emplace_back(point.ms, point.error);
    std::vector<FrontPoint> front;
    for (const std::size_t i : pareto_front(pairs)) front.push_back(points[i]);
    return front;
}

}  // namespace gloam::experiment
