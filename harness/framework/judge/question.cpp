// SPDX-License-Identifier: MIT
#include "judge/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gloam::judge {

using namespace subject;

Criterion Question::criterion_in(const module::Variant& variant) const {
    const bool by_rules =
        variant.strict || variant.relaxed || !variant.steps.empty() || only_rules || !reference;
    return by_rules ? Criterion::rules : Criterion::budget;
}

std::vector<std::pair<ImageScenario, std::size_t>> Question::shares(std::size_t inputs) const {
    if (scenarios.empty()) return {{ImageScenario{}, inputs}};
    std::vector<std::pair<ImageScenario, std::size_t>> all;
    for (std::size_t i = 0; i < std::min(scenarios.size(), inputs); ++i)
        all.emplace_back(scenarios[i], inputs / scenarios.size() + (i < inputs % scenarios.size() ? 1 : 0));
    return all;
}

ImageScenario Question::first_scenario() const {
    return scenarios.empty() ? ImageScenario{} : scenarios.front();
}

ImageScenario Question::scenario_of(const std::string& images) const {
    if (scenarios.empty() && images.empty()) return {};
    const auto found = std::ranges::find(scenarios, images, &ImageScenario::name);
    if (found == scenarios.end())
        throw std::invalid_argument(fmt::format("{}: it has no images \"{}\"", function, images));
    return *found;
}

Question question_of(const Lab& lab, const OwnFunction& own, const Ranges& ranges) {
    Question question{
        .name = own.name, .file = own.file, .function = own.function.name, .signature = own.signature()};
    question.domain = domain_of(own, ranges);
    const auto has_range = [&ranges](const std::string& name) { return range_of(ranges, name).has_value(); };
    question.defined = std::ranges::all_of(own.function.parameters, [&](const module::Parameter& parameter) {
        return parameter.direction == source::Direction::out ||
               parameter.type.scalar == module::Scalar::sampler ||
               std::ranges::all_of(value_names(parameter.type, parameter.name), has_range);
    });
    question.must_hold = own.is_property();
    const KernelSource source = lab.source(own.file, own.function.name, question.signature);
    question.scenarios = random_scenarios(source.images);
    return question;
}

}  // namespace gloam::judge
