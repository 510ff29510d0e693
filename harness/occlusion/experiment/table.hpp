// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiment/results.hpp"
#include "numeric/numbers.hpp"

namespace gloam::experiment {

// The names of what a column can show. Errors are root mean square errors against the traced geometry (G).
[[nodiscard]] const std::vector<std::string>& quantities();

// Of these and some more, those that can be shown by class of pixel, reference and frame.
[[nodiscard]] const std::vector<std::string>& class_quantities();

// Whether a column shows such a part, or a quantity that has no other form.
[[nodiscard]] bool by_class(const Column& column);

struct Text {
    std::string text;    // the tables in Markdown; where a table shows one size, one for each size
    std::string report;  // the same, and those that stand in the report alone
    std::map<std::string, std::string> named;  // those with a name alone
    bool missed = false;                       // a target is missed
};

// The experiment's tables. Over several cases errors are arithmetic means, times geometric ones; "-" stands
// for what was not measured.
[[nodiscard]] Text to_text(const Experiment& experiment, const std::vector<SizeResult>& results);

// What of a cell counts. Of times the passes with this name, or whose names begin with one of the prefixes;
// all where both are empty. Of scores the pixels of a class against a reference, and the last scored frame up
// to `frame`, or all with 0.
struct Part {
    std::vector<std::string> prefixes{};
    std::string name{};
    std::string pixels{};
    std::string against{};
    int frame = 0;
};

// "640 x 360".
[[nodiscard]] std::string size_text(gpu::Extent extent);

// The times of the passes that count in each reading of a cell, in milliseconds.
[[nodiscard]] std::vector<double> times_of(const Cell& cell, const Part& passes);

// The names of a cell's passes, in the order in which they ran. Empty without readings.
[[nodiscard]] std::vector<std::string> passes_of(const Cell& cell);

// A quantity of quantities() over some cases: times are geometric means, all else arithmetic ones.
// statistic: of the readings' times, "median" or "least"; "most", the largest of the cases; "of_best", the
// geometric mean of the ratios to the least value of any candidate in the case; "slope", as in Column.
// nullopt without cases, and where a case lacks it.
[[nodiscard]] std::optional<double> mean_value(const std::vector<const CaseResult*>& cases,
                                               std::size_t candidate, std::string_view quantity,
                                               std::string_view statistic, const Part& part);

// The points (cost, error) that no other point dominates, by their numbers: at least as good in both and
// better in one. Cheapest first; of equal points the first. Points that are not finite are in no front.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points);

// A candidate over some cases: milliseconds against error, RMSE (G). Of more than one case the error is the
// geometric mean of the ratios to the least error of any candidate in the case.
struct FrontPoint {
    std::size_t candidate;
    double ms;
    double error;
};

// Those of the candidates that were judged and timed in all cases.
[[nodiscard]] std::vector<FrontPoint> front_points(const std::vector<const CaseResult*>& cases);

// The points on the front, cheapest first.
[[nodiscard]] std::vector<FrontPoint> front_of(const std::vector<FrontPoint>& points);

// {"versions", "experiment", "device", "driver", "frames", "scored", "repeat", "rays", "sizes": [{"width",
// "height", "cases": [{"case", "what", "kind", "half", "target", "results":
// [{"candidate", the quantities but the times, "ms", "passes": [{"pass", "ms", "least_ms"}],
// "rounds_ms"}]}]}], "visits": [the lines of the record]}. Times are medians. What was not
// measured is null.
[[nodiscard]] std::string to_json(const Experiment& experiment, const std::vector<SizeResult>& results,
                                  const Record& record, const std::string& versions);

// A title line, then a line for each candidate of each case at each size, with every quantity. What was not
// measured is empty.
[[nodiscard]] std::string to_csv(const Experiment& experiment, const std::vector<SizeResult>& results);

}  // namespace gloam::experiment
