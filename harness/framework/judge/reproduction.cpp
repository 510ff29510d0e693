// SPDX-License-Identifier: MIT
#include "judge/reproduction.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "judge/explain.hpp"
#include "judge/internal/budget_judge.hpp"
#include "judge/session.hpp"
#include "module/spirv.hpp"
#include "module/steps.hpp"
#include "module/texts.hpp"
#include "subject/interpreted_kernel.hpp"
#include "subject/kernel_code.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

using module::Scalar;
using Constants = module::Variant::Constants;
using Words = std::vector<Word>;

Session session_of(const Lab& lab, const Question& question, const RunOptions& options,
                   const std::string& scenario) {
    return {lab, question, lab.kernel(question.file, question.function, question.signature),
            question.scenario_of(scenario), options.seed};
}

// The inputs of a check and what they give, in memory in every variant.
Session::Evaluated evaluated(const Lab& lab, const Question& question, const RunOptions& options,
                             const ImageScenario& scenario) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    Domain::Inputs inputs =
        domain_of(lab, question, *kernel.module().source)
            .draw(options.inputs, input_seed_of(question, scenario, options.seed), scenario.size);
    KernelCore::Result result = kernel.run(inputs.words, inputs.count(), images_of(scenario, options.seed));
    return {std::move(inputs), std::move(result)};
}

Reproduction without_verdict(const Lab& lab, const Question& question, const std::string& scenario,
                             const ImageSet& images, std::vector<Word> inputs) {
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    const Constants constants = lab.options().variant.constants;
    const source::Source text{.name = "kernel of " + question.function,
                              .text = constants == Constants::none
                                          ? kernel_code(source)
                                          : constant_kernel_code(source, constants, inputs, 1)};
    const source::Stage stage = stage_of(source.team);
    KernelModule module = kernel_module(source, lab.cache().compile(text, lab.compile_options(stage)));
    try {
        lab.take_steps(module, text);
    } catch (const module::StepError&) {  // the module before them is what there is
    }
    Reproduction all{.glsl = module::pack({text}, {.stage = stage}, lab.options().include_roots),
                     .spirv = std::move(module.spirv),
                     .steps = lab.options().variant.steps,
                     .before = std::move(module.before),
                     .team = source.team,
                     .scenario = scenario,
                     .inputs = std::move(inputs),
                     .specialized = constants == Constants::specialization,
                     .outputs = question.signature.output_scalars()};
    all.assembly = module::disassemble(all.spirv);
    std::vector<std::vector<Word>> words = image_words(module, images);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const ImagePrototype& image = source.images[i];
        all.images.push_back(
            {.name = image.name, .words = std::move(words[i]), .bound = !image.is_prototype()});
    }
    if (const auto language = lab.language())
        all.opengl = gl_kernel_code(*language, source, lab.options().include_roots);
    return all;
}

using Steps = std::vector<std::string>;

// The shortest list, one word at a time, that still fails: halves first, then quarters, to single words.
Steps shortest(Steps words, const std::function<bool(const Steps&)>& fails) {
    for (std::size_t size = std::max<std::size_t>(words.size() / 2, 1); size > 0; size /= 2) {
        for (std::size_t at = 0; at < words.size() && words.size() > 1;) {
            Steps fewer = words;
            const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
            fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, words.size() - at)));
            if (!fewer.empty() && fails(fewer)) {
                words = std::move(fewer);
            } else {
                at += size;
            }
        }
    }
    return words;
}

// The fewest of these steps, and the fewest parts of each, for which `fails` holds: no step and no part can
// be left out alone. `fails` holds for all of them.
Steps shortest_steps(const Steps& steps, const std::function<bool(const Steps&)>& fails) {
    Steps left = shortest(steps, fails);
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Steps parts = module::parts_of(left[i]);
        if (parts.size() < 2) continue;
        const auto with = [&](const Steps& fewer) {
            Steps changed = left;
            changed[i] = module::with_parts(left[i], fewer);
            return changed;
        };
        left = with(shortest(parts, [&](const Steps& fewer) { return fails(with(fewer)); }));
    }
    return left;
}

// The same lab with other steps.
Lab with_steps(const Lab& lab, const std::vector<std::string>& steps) {
    LabOptions options = lab.options();
    options.variant.steps = steps;
    return {std::move(options), lab.backend()};
}

// What the lab with these steps answers; `cannot` where one of them cannot be taken, or makes a module that
// cannot be run. Steps that leave the module as it is do not fail.
bool after(const Steps& steps, const Lab& lab, bool cannot, const std::function<bool(const Lab&)>& fails) {
    try {
        return fails(with_steps(lab, steps));
    } catch (const backend::Fault&) {
        return cannot;
    } catch (const module::StepError&) {
        return cannot;
    } catch (const module::Unchanged&) {
        return false;
    } catch (const backend::Unsupported&) {
        return false;
    }
}

// The inputs that ran in one group with a failing one.
std::vector<Words> group_of(const Lab& lab, const Question& question, const Session& session,
                            const RunOptions& options, const Sample& failing) {
    std::vector<Words> group;
    for (const auto& [scenario, share] : question.shares(options.inputs)) {
        if (scenario.name != failing.scenario) continue;
        const Domain::Inputs all =
            domain_of(lab, question, session.source()).draw(share, session.input_seed(), scenario.size);
        const std::size_t first = failing.index / kernel_group_size * kernel_group_size;
        for (std::size_t i = first; i < std::min(first + kernel_group_size, all.count()); ++i)
            group.emplace_back(all.row(i).begin(), all.row(i).end());
    }
    return group;
}

Reproduction reproduce_with(const Lab& lab, const Question& question, const RunOptions& options,
                            const Sample& failing) {
    const Session session = session_of(lab, question, options, failing.scenario);
    const auto first_failing = [&](std::span<const Words> inputs) { return session.first_failing(inputs); };
    const bool alone = lab.options().variant.constants != Constants::none ||
                       first_failing(std::span(&failing.inputs, 1)).has_value();
    std::vector<Words> group;
    if (!alone) group = group_of(lab, question, session, options, failing);
    const std::optional<Sample> beside = first_failing(group);
    Sample smallest = beside ? *beside : shrink(question, failing, first_failing);
    if (!beside) group = {smallest.inputs};
    Words inputs;
    for (const Words& one : group) inputs.insert(inputs.end(), one.begin(), one.end());
    Reproduction all = without_verdict(lab, question, failing.scenario, session.images(), std::move(inputs));
    all.count = group.size();
    all.failing = beside ? beside->index : 0;
    all.outcomes = allowed_outcomes(question, session.images(), smallest);
    if (!smallest.forbidden) smallest.permitted = all.outcomes.front();
    all.failure = smallest;
    try {
        all.rules =
            rules_of(explain(lab.judged_options(), session.source(), smallest.inputs, session.images()));
    } catch (const std::exception&) {  // a shader that the interpreter cannot run has a report still
    }
    return all;
}

}  // namespace

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options) {
    const ImageScenario scenario = question.first_scenario();
    const std::vector<std::string>& steps = lab.options().variant.steps;
    const auto fails = [&](const Steps& fewer) {
        return after(fewer, lab, true, [&](const Lab& other) {
            static_cast<void>(evaluated(other, question, options, scenario));
            return false;
        });
    };
    const bool reducible = !steps.empty() && fails(steps);
    const Lab of_fewest = with_steps(lab, reducible ? shortest_steps(steps, fails) : steps);
    return without_verdict(of_fewest, question, scenario.name, images_of(scenario, options.seed),
                           question.domain.draw(1, options.seed, scenario.size).words);
}

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options,
                       const Sample& failing) {
    const std::vector<std::string>& steps = lab.options().variant.steps;
    if (steps.empty()) return reproduce_with(lab, question, options, failing);
    const auto fails = [&](const Steps& fewer) {
        return after(fewer, lab, false, [&](const Lab& other) {
            const Session session = session_of(other, question, options, failing.scenario);
            return session.first_failing(std::span(&failing.inputs, 1)).has_value();
        });
    };
    return reproduce_with(with_steps(lab, shortest_steps(steps, fails)), question, options, failing);
}

Reproduction reproduce_fault(const Lab& lab, const Question& question, const RunOptions& options) {
    for (const ImageScenario& scenario : question.scenarios) {
        const auto [inputs, result] = evaluated(lab, question, options, scenario);
        if (!result.fault) continue;
        const std::span<const Word> row = inputs.row(result.fault->input);
        return without_verdict(lab, question, scenario.name, images_of(scenario, options.seed),
                               {row.begin(), row.end()});
    }
    throw std::invalid_argument(fmt::format("{}: no access falls outside an image", question.function));
}

std::vector<Sample::Outcome> allowed_outcomes(const Question& question, const ImageSet& images,
                                              const Sample& sample) {
    if (sample.forbidden) return sample.permitted_outcomes();
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    using numeric::Bounds;
    const Bounds codomain{question.codomain.low, question.codomain.high, false};
    std::vector<Bounds> bounds(scalars.size(), codomain);
    // Elsewhere only the codomain is promised.
    if (question.promised && !question.promised(sample.inputs)) return {bounds};
    bounds = internal::allowed_around(question, sample.want);
    if (!question.reference) return {bounds};  // a property: true
    std::vector<double> want;
    const auto add = [&](const std::vector<Word>& inputs) {
        question.reference(images, inputs, want);
        std::ranges::transform(bounds, internal::allowed_around(question, want), bounds.begin(),
                               numeric::hull);
        return false;
    };
    internal::visit_covered_inputs(question.budget, question.signature.input_scalars(), sample.inputs, add);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (!module::is_float(scalars[i]) || bounds[i].empty()) continue;
        bounds[i].low = std::max(bounds[i].low, codomain.low);
        bounds[i].high = std::min(bounds[i].high, codomain.high);
    }
    return {bounds};
}

}  // namespace gloam::judge
