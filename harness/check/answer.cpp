// SPDX-License-Identifier: MIT
#include "check/answer.hpp"

#include <algorithm>
#include <numeric>

namespace gloam::check {
namespace {

std::size_t total(const std::array<ClassCount, input_class_count>& classes,
                  std::size_t ClassCount::* member) {
    return std::accumulate(
        classes.begin(), classes.end(), std::size_t{0},
        [member](std::size_t sum, const ClassCount& count) { return sum + count.*member; });
}

bool is_worse(const Sample& sample, const std::optional<Sample>& worst) {
    return !worst || sample.fraction > worst->fraction;
}

}  // namespace

std::string_view name_of(Reason reason) {
    switch (reason) {
        case Reason::crash:
            return "crash";
        case Reason::hang:
            return "hang";
        case Reason::device_lost:
            return "device lost";
        case Reason::out_of_memory:
            return "out of memory";
        case Reason::error:
            return "error";
        case Reason::fault:
            return "fault";
        case Reason::unsupported:
            return "unsupported";
        case Reason::none:
            break;
    }
    return "";
}

std::size_t Answer::inputs() const {
    return total(classes, &ClassCount::inputs);
}
std::size_t Answer::outside() const {
    return total(classes, &ClassCount::outside);
}
std::size_t Answer::recorded() const {
    return total(classes, &ClassCount::recorded);
}

void Answer::add(const Sample& sample, bool is_outside) {
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

void Answer::add_unbounded(const Sample& sample) {
    ++unbounded;
    if (!first_unbounded) first_unbounded = sample;
}

void Answer::add_guarantee(const Guarantee& more) {
    guarantee = {std::max(guarantee.ulp, more.ulp), std::max(guarantee.absolute, more.absolute),
                 std::max(guarantee.fraction, more.fraction)};
}

void Answer::merge(const Answer& later) {
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
    differs += later.differs;
    if (!first_unbounded) first_unbounded = later.first_unbounded;
    if (later.worst && is_worse(*later.worst, worst)) worst = later.worst;
}

}  // namespace gloam::check
