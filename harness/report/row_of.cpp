// SPDX-License-Identifier: MIT
#include "report/row_of.hpp"

#include "check/describe.hpp"

namespace gloam::report {
namespace {

BudgetNumbers budget_of(const check::Budget& budget) {
    return {.ulp = budget.ulp,
            .absolute = budget.absolute,
            .backward_ulp = budget.backward_ulp,
            .text = check::to_text(budget)};
}

std::vector<AllowedNumbers> allowed_of(const std::vector<numeric::Bounds>& permitted) {
    std::vector<AllowedNumbers> allowed;
    for (const numeric::Bounds& bounds : permitted) {
        allowed.push_back({.low = bounds.low, .high = bounds.high, .nan = bounds.nan});
    }
    return allowed;
}

std::vector<ClassNumbers> classes_of(const check::Census& census) {
    std::vector<ClassNumbers> classes;
    for (std::size_t i = 0; i < check::input_class_count; ++i) {
        const check::ClassCount& count = census.classes[i];
        if (count.inputs == 0) continue;
        classes.push_back({.name = std::string(check::name_of(static_cast<check::InputClass>(i))),
                           .inputs = count.inputs,
                           .outside = count.outside,
                           .recorded = count.recorded});
    }
    return classes;
}

}  // namespace

WorstInput worst_of(const check::Signature& signature, const check::Sample& sample) {
    return {.input = sample.index,
            .input_class = std::string(check::name_of(sample.input_class)),
            .images = sample.scenario,
            .values = check::describe_inputs(signature, sample.inputs),
            .input_words = sample.inputs,
            .got_words = sample.got,
            .want = sample.want,
            .allowed = allowed_of(sample.permitted),
            .ulp = sample.ulp,
            .absolute = sample.absolute};
}

CheckRow row_of(const std::string& equation, const std::string& variant, const check::Result& result) {
    const check::Census& census = result.census;
    CheckRow row{.equation = equation,
                 .function = result.function,
                 .file = result.file,
                 .variant = variant,
                 .verdict = std::string(check::name_of(result.verdict)),
                 .inputs = census.inputs(),
                 .outside = census.outside(),
                 .recorded = census.recorded(),
                 .unbounded = census.unbounded,
                 .differs = result.differs,
                 .max_ulp = census.max_ulp,
                 .max_abs = census.max_absolute,
                 .width_fraction = std::nullopt,
                 .budget_fraction = census.budget_fraction,
                 .guarantee = std::nullopt,
                 .unbounded_at = {},
                 .budget = budget_of(result.budget),
                 .classes = classes_of(census),
                 .worst = std::nullopt,
                 .fault = {},
                 .error = {},
                 .reason = result.fault ? Reason::fault : Reason::none,
                 .story = result.passed() ? std::string{} : check::describe(result)};
    if (census.worst) row.worst = worst_of(result.signature, *census.worst);
    if (result.verdict == check::Verdict::rules) {
        row.width_fraction = census.fraction;
        row.guarantee = GuaranteeNumbers{.ulp = census.guarantee.ulp,
                                         .absolute = census.guarantee.absolute,
                                         .fraction = census.guarantee.fraction};
    }
    if (census.first_unbounded) {
        row.unbounded_at = check::describe_inputs(result.signature, census.first_unbounded->inputs);
    }
    if (result.fault) row.fault = check::to_text(*result.fault);
    return row;
}

}  // namespace gloam::report
