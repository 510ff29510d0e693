// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "scene/scene.hpp"

namespace gloam::effect {

// A number that a search may change.
struct SearchRange {
    std::string name;
    double least = 0.0;
    double most = 1.0;
    bool whole = false;
    bool logarithmic = false;  // steps are factors; needs least > 0
};

// An evaluated point.
struct SearchPoint {
    std::vector<double> at;  // a number for each range
    double value = 0.0;
    bool improves = false;  // it was the best so far
};

struct SearchOutcome {
    SearchPoint best;
    std::vector<SearchPoint> points;  // in the order of their evaluation, the start first
};

// Throws std::invalid_argument that names the first range that is empty, not finite, or logarithmic without
// least > 0.
void validate(const std::vector<SearchRange>& ranges);

// A coordinate pattern search for the least value. Steps begin at a quarter of each range. In turn, each
// parameter is moved by its step up and then down, and a point that is better is kept. A round without a gain
// halves the steps. It ends when the steps are below 1/64 of the ranges, or after `evaluations` (>= 1)
// points. No point is evaluated twice. start: limited to the ranges. Throws like validate(), and whatever
// `value_at` throws.
[[nodiscard]] SearchOutcome pattern_search(const std::vector<SearchRange>& ranges,
                                           const std::vector<double>& start, int evaluations,
                                           const std::function<double(const std::vector<double>&)>& value_at);

// What is to be least over the tuning half.
enum class TuneObjective {
    mean,     // the mean RMSE: views with large errors count most
    relative  // the geometric mean of each view's RMSE over that of the start: all views count alike
};

struct TuneTask {
    Settings start;                       // lengths for a radius of 1
    std::vector<SearchRange> parameters;  // names of settings that are numbers
    TuneObjective objective = TuneObjective::mean;
    int evaluations = 60;
    std::optional<double> copies;  // largest mean time of a frame, in copies; without it any
};

// What a view says about settings.
struct ViewMeasure {
    double rmse = 0.0;    // against (G)
    double copies = 0.0;  // time of a frame; 0 where the task has no limit
};

// Measures settings, whose lengths are for a radius of 1, on a view.
using MeasureView = std::function<ViewMeasure(const scene::ViewInfo&, const Settings&)>;

// A view before and after.
struct TunedView {
    scene::ViewInfo view;
    ViewMeasure before;
    ViewMeasure after;
};

struct TuneOutcome {
    Settings settings;
    SearchOutcome search;
    std::vector<TunedView> views;  // all of both halves, in their order
};

// A setting with its range as a parameter: "NAME=LEAST:MOST" or "NAME=LEAST:MOST:log". Throws
// std::invalid_argument that quotes the text, for a setting that is unknown or not a number, and for a range
// that is not within the setting's own.
[[nodiscard]] SearchRange tuned_parameter(const std::string& text);

// Searches the parameters for the least objective over the views of the tuning half. Then the start and the
// result are measured once on the views of the unseen half; no other settings are ever measured there. Points
// beyond the limit of time, or that Settings' validate() rejects, count as worse than any other. Throws
// std::invalid_argument without parameters or without views of both halves, and if the start itself is
// invalid.
[[nodiscard]] TuneOutcome tune(const TuneTask& task, const std::vector<scene::ViewInfo>& views,
                               const MeasureView& measure, const std::function<void(double)>& progress = {});

}  // namespace gloam::effect
