// SPDX-License-Identifier: MIT
#include "check/census.hpp"

#include <algorithm>
#include <numeric>

namespace gloam::check {
namespace {

std::size_t total(const std::array<ClassCount, input_class_count>& classes, std::size_t ClassCount::*member) {
    return std::accumulate(
        classes.begin(), classes.end(), std::size_t{0},
        [member](std::size_t sum, const ClassCount& count) { return sum + count.*member; });
}

bool is_worse(const Sample& sample, const std::optional<Sample>& worst) {
    return !worst || sample.fraction > worst->fraction;
}

}  // namespace

std::size_t Census::inputs() const {
    return total(classes, &ClassCount::inputs);
}
std::size_t Census::outside() const {
    return total(classes, &ClassCount::outside);
}
std::size_t Census::recorded() const {
    return total(classes, &ClassCount::recorded);
}

void Census::add(const Sample& sample, bool is_outside) {
    ++count(sample.input_class).inputs;
    max_ulp = std::max(max_ulp, sample.ulp);
    max_absolute = std::max(max_absolute, sample.absolute);
    fraction = std::max(fraction, sample.fraction);
    budget_fraction = std::max(budget_fraction, sample.budget_fraction);
    if (sample.fraction > 0.0 && is_worse(sample, worst)) worst = sample;
    if (sample.forbidden) ++forbidden;
    if (!is_outside) return;
    ++count(sample.input_class).outside;
    auto& first = first_outside.at(static_cast<std::size_t>(sample.input_class));
    if (!first) first = sample;
}

void Census::add_unbounded(const Sample& sample) {
    ++unbounded;
    if (!first_unbounded) first_unbounded = sample;
}

void Census::add_guarantee(const Guarantee& more) {
    guarantee = {std::max(guarantee.ulp, more.ulp), std::max(guarantee.absolute, more.absolute),
                 std::max(guarantee.fraction, more.fraction)};
}

void Census::merge(const Census& later) {
    for (std::size_t i = 0; i < input_class_count; ++i) {
        classes[i].inputs += later.classes[i].inputs;
        classes[i].outside += later.classes[i].outside;
        classes[i].recorded += later.classes[i].recorded;
        if (!first_outside[i]) first_outside[i] = later.first_outside[i];
    }
    max_ulp = std::max(max_ulp, later.max_ulp);
    max_absolute = std::max(max_absolute, later.max_absolute);
    fraction = std::max(fraction, later.fraction);
    budget_fraction = std::max(budget_fraction, later.budget_fraction);
    add_guarantee(later.guarantee);
    by_rules += later.by_rules;
    forbidden += later.forbidden;
    bounded += later.bounded;
    unbounded += later.unbounded;
    if (!first_unbounded) first_unbounded = later.first_unbounded;
    if (later.worst && is_worse(*later.worst, worst)) worst = later.worst;
}

}  // namespace gloam::check
