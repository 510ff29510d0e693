// SPDX-License-Identifier: MIT
#include "effect/study/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "effect/setting_table.hpp"

namespace gloam::effect {
namespace {

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
    double value = 0.0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && rest == text.data() + text.size()) return value;
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
