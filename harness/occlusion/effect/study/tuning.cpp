// SPDX-License-Identifier: MIT
#include "effect/study/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/number.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {
namespace {

constexpr double first_step = 0.25;
constexpr double last_step = 1.0 / 64.0;

// A value as its place in the range, [0, 1], and back.
double place_of(const SearchRange& range, double value) {
    const double place = range.logarithmic
                             ? std::log(value / range.least) / std::log(range.most / range.least)
                             : (value - range.least) / (range.most - range.least);
    return std::clamp(place, 0.0, 1.0);
}

double value_of(const SearchRange& range, double place) {
    const double value = range.logarithmic ? range.least * std::pow(range.most / range.least, place)
                                           : range.least + place * (range.most - range.least);
    return std::clamp(range.whole ? std::round(value) : value, range.least, range.most);
}

// The search's state: places, the points so far, the budget.
class Search {
  public:
    Search(const std::vector<SearchRange>& ranges, const std::vector<double>& start, int evaluations,
           const std::function<double(const std::vector<double>&)>& value_at)
        : ranges_(&ranges), evaluations_(evaluations), value_at_(&value_at) {
        for (std::size_t i = 0; i < ranges.size(); ++i) places_.push_back(place_of(ranges[i], start.at(i)));
        (void)gains(places_);
    }

    [[nodiscard]] SearchOutcome run() {
        for (double step = first_step; step >= last_step && !spent();)
            if (!round(step)) step *= 0.5;
        return {best_, points_};
    }

  private:
    [[nodiscard]] bool spent() const { return points_.size() >= static_cast<std::size_t>(evaluations_); }

    // Tries each parameter in both directions; whether any point was better.
    bool round(double step) {
        bool gained = false;
        for (std::size_t i = 0; i < ranges_->size(); ++i) gained |= moved(i, step) || moved(i, -step);
        return gained;
    }

    bool moved(std::size_t i, double step) {
        std::vector<double> places = places_;
        places[i] = std::clamp(places[i] + step, 0.0, 1.0);
        if (spent() || !gains(places)) return false;
        places_ = std::move(places);
        return true;
    }

    // Evaluates the point unless it is known; whether it is the best so far.
    bool gains(const std::vector<double>& places) {
        std::vector<double> at;
        for (std::size_t i = 0; i < ranges_->size(); ++i) at.push_back(value_of((*ranges_)[i], places[i]));
        const auto is_there = [&](const SearchPoint& point) { return point.at == at; };
        if (std::ranges::any_of(points_, is_there)) return false;
        SearchPoint point{.at = at, .value = (*value_at_)(at)};
        point.improves = points_.empty() || point.value < best_.value;
        if (point.improves) best_ = point;
        points_.push_back(point);
        return point.improves;
    }

    const std::vector<SearchRange>* ranges_;
    int evaluations_;
    const std::function<double(const std::vector<double>&)>* value_at_;
    std::vector<double> places_;
    SearchPoint best_;
    std::vector<SearchPoint> points_;
};

using scene::ViewHalf;
using scene::ViewInfo;

constexpr double unusable = std::numeric_limits<double>::infinity();

std::vector<ViewInfo> half_of(const std::vector<ViewInfo>& views, ViewHalf half) {
    std::vector<ViewInfo> some;
    for (const ViewInfo& view : views)
        if (view.half == half) some.push_back(view);
    return some;
}

double number_from(std::string_view text, const std::string& whole) {
    if (const auto number = base::number_from<double>(text)) return *number;
    throw std::invalid_argument(
        fmt::format("--parameter {}: expected NAME=LEAST:MOST or NAME=LEAST:MOST:log", whole));
}

// The objective over the tuning half, and what was measured for it.
class Objective {
  public:
    Objective(const TuneTask& task, std::vector<ViewInfo> views, const MeasureView& measure)
        : task_(&task), views_(std::move(views)), measure_(&measure) {}

    [[nodiscard]] Settings settings_at(const std::vector<double>& at) const {
        Settings settings = task_->start;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Setting& setting = setting_named(task_->parameters[i].name);
            setting.put(settings, at[i]);
        }
        return settings;
    }

    [[nodiscard]] double value_of(const std::vector<ViewMeasure>& measured) const {
        double sum = 0.0;
        double copies = 0.0;
        for (std::size_t i = 0; i < measured.size(); ++i) {
            sum += task_->objective == TuneObjective::mean ? measured[i].rmse
                                                           : std::log(measured[i].rmse / before_[i].rmse);
            copies += measured[i].copies;
        }
        const auto count = static_cast<double>(measured.size());
        if (task_->copies && copies / count > *task_->copies) return unusable;
        return task_->objective == TuneObjective::mean ? sum / count : std::exp(sum / count);
    }

    double operator()(const std::vector<double>& at) {
        const Settings settings = settings_at(at);
        try {
            validate(settings);
        } catch (const std::invalid_argument&) {
            return unusable;
        }
        std::vector<ViewMeasure> measured;
        for (const ViewInfo& view : views_) measured.push_back((*measure_)(view, settings));
        if (before_.empty()) before_ = measured;
        const double value = value_of(measured);
        if (!found_ || value < least_) {
            least_ = value;
            after_ = measured;
            found_ = true;
        }
        return value;
    }

    [[nodiscard]] TunedView tuned(std::size_t view) const {
        return {views_.at(view), before_.at(view), after_.at(view)};
    }
    [[nodiscard]] std::size_t count() const { return views_.size(); }

  private:
    const TuneTask* task_;
    std::vector<ViewInfo> views_;
    const MeasureView* measure_;
    std::vector<ViewMeasure> before_;  // of the start
    std::vector<ViewMeasure> after_;   // of the best so far
    double least_ = unusable;
    bool found_ = false;
};

std::vector<double> start_of(const TuneTask& task) {
    std::vector<double> start;
    for (const SearchRange& parameter : task.parameters)
        start.push_back(std::get<double>(setting_named(parameter.name).get(task.start)));
    return start;
}

void require_both(const std::vector<ViewInfo>& views) {
    for (const ViewHalf half : {ViewHalf::tuning, ViewHalf::unseen})
        if (half_of(views, half).empty())
            throw std::invalid_argument(fmt::format("no view of the {} half", scene::name_of(half)));
}

// The tuning views as the search measured them, the unseen ones measured now; in the order of the list.
std::vector<TunedView> judged(const std::vector<ViewInfo>& views, const Objective& objective,
                              const Settings& before, const Settings& after, const MeasureView& measure) {
    std::vector<TunedView> all;
    std::size_t tuning = 0;
    for (const ViewInfo& view : views) {
        if (view.half == ViewHalf::tuning)
            all.push_back(objective.tuned(tuning++));
        else
            all.push_back({view, measure(view, before), measure(view, after)});
    }
    return all;
}

}  // namespace

void validate(const std::vector<SearchRange>& ranges) {
    for (const SearchRange& range : ranges) {
        const bool finite = std::isfinite(range.least) && std::isfinite(range.most);
        if (!finite || !(range.least < range.most))
            throw std::invalid_argument(fmt::format("{} from {} to {}: expected two numbers, the lower first",
                                                    range.name, range.least, range.most));
        if (range.logarithmic && !(range.least > 0.0))
            throw std::invalid_argument(fmt::format("{} from {} to {}: a logarithmic range begins above 0",
                                                    range.name, range.least, range.most));
    }
}

SearchOutcome pattern_search(const std::vector<SearchRange>& ranges, const std::vector<double>& start,
                             int evaluations,
                             const std::function<double(const std::vector<double>&)>& value_at) {
    validate(ranges);
    if (ranges.empty() || start.size() != ranges.size())
        throw std::invalid_argument("a search without parameters, or a start of another size");
    if (evaluations < 1)
        throw std::invalid_argument(fmt::format("{} evaluations: expected 1 or more", evaluations));
    return Search(ranges, start, evaluations, value_at).run();
}

SearchRange tuned_parameter(const std::string& text) {
    constexpr std::string_view log_mark = ":log";
    const std::size_t equals = text.find('=');
    const std::size_t colon = text.find(':');
    if (equals == std::string::npos || colon == std::string::npos || colon < equals)
        (void)number_from("", text);
    const bool logarithmic = text.ends_with(log_mark);
    const std::size_t end = logarithmic ? text.size() - log_mark.size() : text.size();
    if (end <= colon) (void)number_from("", text);
    const Setting& setting = setting_named(text.substr(0, equals));
    if (!std::holds_alternative<double>(setting.get(Settings{})))
        throw std::invalid_argument(fmt::format("--parameter {}: {} is not a number", text, setting.name));
    SearchRange parameter{.name = setting.name,
                          .least = number_from(text.substr(equals + 1, colon - equals - 1), text),
                          .most = number_from(text.substr(colon + 1, end - colon - 1), text),
                          .whole = setting.range.whole,
                          .logarithmic = logarithmic};
    validate({parameter});
    check(setting, parameter.least);
    check(setting, parameter.most);
    return parameter;
}

TuneOutcome tune(const TuneTask& task, const std::vector<ViewInfo>& views, const MeasureView& measure,
                 const std::function<void(double)>& progress) {
    if (task.parameters.empty()) throw std::invalid_argument("nothing to tune: give --parameter");
    validate(task.start);
    require_both(views);
    // The search begins at the start limited to the ranges: `before` is that point.
    Objective objective(task, half_of(views, ViewHalf::tuning), measure);
    int evaluated = 0;
    const SearchOutcome search =
        pattern_search(task.parameters, start_of(task), task.evaluations, [&](const std::vector<double>& at) {
            const double value = objective(at);
            if (progress) progress(static_cast<double>(++evaluated) / task.evaluations);
            return value;
        });
    if (progress) progress(1.0);
    if (!std::isfinite(search.best.value))
        throw std::invalid_argument("no settings within the ranges are valid and within the limit of time");
    const Settings settings = objective.settings_at(search.best.at);
    const Settings before = objective.settings_at(search.points.front().at);
    return {settings, search, judged(views, objective, before, settings, measure)};
}

}  // namespace gloam::effect
