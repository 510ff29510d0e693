// SPDX-License-Identifier: MIT
#include "effect/study/pattern_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

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

}  // namespace gloam::effect
