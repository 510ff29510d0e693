// SPDX-License-Identifier: MIT
#include "check/reproduction.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "check/explain.hpp"
#include "check/internal/budget_judge.hpp"
#include "check/internal/interpretation.hpp"
#include "check/internal/kernel_text.hpp"
#include "check/internal/trial.hpp"
#include "check/interpreted_kernel.hpp"
#include "check/kernel_code.hpp"
#include "numeric/numbers.hpp"
#include "shader/pack.hpp"
#include "shader/spirv.hpp"
#include "shader/steps.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;
using Constants = shader::Variant::Constants;
using Words = std::vector<Word>;

ImageScenario scenario_of(const Question& question, const std::string& name) {
    if (question.scenarios.empty() && name.empty()) return {};
    const auto found = std::ranges::find(question.scenarios, name, &ImageScenario::name);
    if (found == question.scenarios.end()) {
        throw std::invalid_argument(fmt::format("{}: it has no images \"{}\"", question.function, name));
    }
    return *found;
}

// A question that is ready to run with the images of one scenario, as run() does it.
class Stage {
  public:
    Stage(const Lab& lab, const Question& question, ImageScenario scenario, const RunOptions& options)
        : lab_(lab),
          question_(question),
          scenario_(std::move(scenario)),
          kernel_(lab.kernel(question.file, question.function, question.signature)),
          trial_(lab, question, kernel_, scenario_, options.seed,
                 verdict_of(lab.options().variant, question)),
          options_(trial_.judge_options()) {
        if (lab.options().variant.constants == Constants::none) return;
        constants_.emplace(lab, question.file, question.function, question.signature);
        options_.nan = options_.nan && constants_->preserves_nan();
    }

    [[nodiscard]] const JudgeOptions& judge_options() const { return options_; }
    [[nodiscard]] const ImageSet& images() const { return trial_.images(); }
    [[nodiscard]] std::size_t at_once() const { return constants_ ? ConstantKernel::most_inputs : 1U << 20U; }
    [[nodiscard]] KernelCore::Result run(std::span<const Word> inputs, std::size_t count) const {
        return constants_ ? constants_->run(inputs, count, images()) : kernel_.run(inputs, count, images());
    }
    // Runs with the inputs in memory, in every variant.
    [[nodiscard]] KernelCore::Result run_kernel(const Domain::Inputs& inputs) const {
        return kernel_.run(inputs.words, inputs.count(), images());
    }
    [[nodiscard]] Domain::Inputs draw(std::size_t count) const {
        return internal::domain_of(lab_, question_).draw(count, trial_.input_seed(), scenario_.size);
    }

  private:
    const Lab& lab_;
    const Question& question_;
    ImageScenario scenario_;
    KernelCore kernel_;
    internal::Trial trial_;
    JudgeOptions options_;
    std::optional<ConstantKernel> constants_;
};

// The generated shader for one input. If the variant makes inputs literals, the input is in the text.
std::string code_of(KernelSource source, Constants constants, const std::vector<Word>& inputs) {
    if (constants == Constants::specialization) return specialized_kernel_code(source, 1);
    if (constants == Constants::none) return kernel_code(source);
    source.preserve_nan = false;  // as in ConstantKernel
    return literal_kernel_code(source, inputs, 1);
}

// The texts for an OpenGL device, once what is allowed is known.
void add_opengl(const Lab& lab, const KernelSource& source, Reproduction& all) {
    const auto language = lab.language();
    if (!language) return;
    all.opengl = all.opengl_replay = internal::gl_kernel_code(*language, source, lab.options().include_roots);
    if (internal::has_compute(*language)) return;
    // Without compute shaders there are no precision rules, so no more than one outcome.
    internal::GlReplay replay{.image_words = {}, .outputs = all.outputs, .allowed = {}};
    if (!all.outcomes.empty()) replay.allowed = all.outcomes.front();
    for (const Reproduction::ImageBuffer& image : all.images)
        replay.image_words.push_back(image.words.size());
    all.opengl_replay = internal::gl_replay_code(*language, source, replay, lab.options().include_roots);
}

Reproduction without_verdict(const Lab& lab, const Question& question, const std::string& scenario,
                             const ImageSet& images, std::vector<Word> inputs) {
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    const Constants constants = lab.options().variant.constants;
    const shader::Source text{.name = "kernel of " + question.function,
                              .text = code_of(source, constants, inputs)};
    shader::CompileOptions in_stage = lab.compile_options();
    in_stage.stage = stage_of(source.team);
    KernelModule module{.spirv = lab.compile(text, in_stage), .team = source.team};
    try {
        lab.take_steps(module, text);
    } catch (const shader::StepError&) {  // the module before them is what there is
    }
    Reproduction all{.glsl = shader::pack({text}, {.stage = in_stage.stage}, lab.options().include_roots),
                     .spirv = std::move(module.spirv),
                     .steps = lab.options().variant.steps,
                     .before = std::move(module.before),
                     .team = source.team,
                     .scenario = scenario,
                     .inputs = std::move(inputs),
                     .specialized = constants == Constants::specialization,
                     .outputs = question.signature.output_scalars()};
    all.assembly = shader::disassemble(all.spirv);
    std::vector<std::vector<Word>> words = image_words(source.images, images, question.function);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const ImagePrototype& image = source.images[i];
        all.images.push_back(
            {.name = image.name, .words = std::move(words[i]), .bound = !image.is_prototype()});
    }
    add_opengl(lab, source, all);
    return all;
}

}  // namespace

namespace {

// The same lab with other steps.
Lab with_steps(const Lab& lab, const std::vector<std::string>& steps) {
    LabOptions options = lab.options();
    options.variant.steps = steps;
    return {std::move(options), lab.backend()};
}

// Whether one of these steps cannot be taken, or makes a module that cannot be run.
bool cannot_run(const Lab& lab, const Question& question, const RunOptions& options,
                const ImageScenario& scenario, const std::vector<std::string>& steps) {
    try {
        const Lab other = with_steps(lab, steps);
        const Stage stage(other, question, scenario, options);
        static_cast<void>(stage.run_kernel(stage.draw(options.inputs)));
    } catch (const backend::Fault&) {
        return true;
    } catch (const shader::StepError&) {
        return true;
    } catch (const shader::Unchanged&) {
        return false;
    }
    return false;
}

// Whether these inputs fail after these steps. Those that cannot be taken, or leave the module as it is, do
// not fail in this way.
bool fails_after(const Lab& lab, const Question& question, const RunOptions& options, const Sample& failing,
                 const std::vector<std::string>& steps) {
    try {
        const Lab other = with_steps(lab, steps);
        const Stage stage(other, question, scenario_of(question, failing.scenario), options);
        JudgeOptions judging = stage.judge_options();
        const KernelCore::Result result = stage.run(failing.inputs, 1);
        judging.modules = result.modules;
        const Domain::Inputs inputs{
            .words = failing.inputs, .branch = {false}, .width = failing.inputs.size()};
        return judge(question, judging, inputs, result.outputs, stage.images()).outside() > 0;
    } catch (const shader::StepError&) {
        return false;
    } catch (const shader::Unchanged&) {
        return false;
    } catch (const backend::Fault&) {
        return false;
    }
}

Reproduction reproduce_with(const Lab& lab, const Question& question, const RunOptions& options,
                            const Sample& failing) {
    const Stage stage(lab, question, scenario_of(question, failing.scenario), options);
    const ShrinkScope scope{.question = question,
                            .options = stage.judge_options(),
                            .images = stage.images(),
                            .evaluate = [&stage](std::span<const Word> inputs,
                                                 std::size_t count) { return stage.run(inputs, count); },
                            .at_once = stage.at_once()};
    Sample smallest = shrink(scope, failing);
    Reproduction all = without_verdict(lab, question, failing.scenario, stage.images(), smallest.inputs);
    all.outcomes = allowed_outcomes(question, stage.images(), smallest);
    if (!smallest.forbidden) smallest.permitted = all.outcomes.front();
    add_opengl(lab, lab.source(question.file, question.function, question.signature), all);
    all.failure = smallest;
    try {
        all.rules = rules_of(explain(lab.compile_options(),
                                     lab.source(question.file, question.function, question.signature),
                                     smallest.inputs, stage.images()));
    } catch (const std::exception&) {  // a shader that the interpreter cannot run has a report still
    }
    return all;
}

}  // namespace

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options) {
    const ImageScenario scenario = question.scenarios.empty() ? ImageScenario{} : question.scenarios.front();
    const std::vector<std::string>& steps = lab.options().variant.steps;
    const auto fails = [&](const std::vector<std::string>& fewer) {
        return cannot_run(lab, question, options, scenario, fewer);
    };
    const bool reducible = !steps.empty() && fails(steps);
    const Lab of_fewest = with_steps(lab, reducible ? shortest_steps(steps, fails) : steps);
    return without_verdict(of_fewest, question, scenario.name, internal::images_of(scenario, options.seed),
                           question.domain.draw(1, options.seed, scenario.size).words);
}

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options,
                       const Sample& failing) {
    const std::vector<std::string>& steps = lab.options().variant.steps;
    if (steps.empty()) return reproduce_with(lab, question, options, failing);
    const auto fails = [&](const std::vector<std::string>& fewer) {
        return fails_after(lab, question, options, failing, fewer);
    };
    return reproduce_with(with_steps(lab, shortest_steps(steps, fails)), question, options, failing);
}

Reproduction reproduce_fault(const Lab& lab, const Question& question, const RunOptions& options) {
    for (const ImageScenario& scenario : question.scenarios) {
        const Stage stage(lab, question, scenario, options);
        const Domain::Inputs inputs = stage.draw(options.inputs);
        const KernelCore::Result result = stage.run_kernel(inputs);
        if (!result.fault) continue;
        const std::span<const Word> row = inputs.row(result.fault->input);
        return without_verdict(lab, question, scenario.name, stage.images(), {row.begin(), row.end()});
    }
    throw std::invalid_argument(fmt::format("{}: no access falls outside an image", question.function));
}

namespace {

using numeric::Bounds;

// The budget around one result of the reference, where `unit` is the size of an ULP.
Bounds around(double want, double unit, const Budget& budget) {
    if (std::isnan(want)) return Bounds::only_nan();
    if (!std::isfinite(want)) return Bounds::point(want);
    const double reach = std::max(budget.absolute, budget.ulp * unit);
    return {want - reach, want + reach, false};
}

std::vector<Bounds> around(const Question& question, const std::vector<double>& want) {
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    std::vector<Bounds> bounds;
    for (const std::size_t words : question.signature.output_values()) {
        const std::size_t first = bounds.size();
        double largest = 0.0;
        for (std::size_t i = first; i < first + words; ++i) {
            if (std::isfinite(want[i])) largest = std::max(largest, std::abs(want[i]));
        }
        for (std::size_t i = first; i < first + words; ++i) {
            if (!shader::is_float(scalars[i])) {
                bounds.push_back(Bounds::point(want[i]));
                continue;
            }
            const double at = question.budget.of_largest_component ? largest : want[i];
            bounds.push_back(around(want[i], format_of(scalars[i]).ulp(at), question.budget));
        }
    }
    return bounds;
}

}  // namespace

std::vector<Sample::Outcome> allowed_outcomes(const Question& question, const ImageSet& images,
                                              const Sample& sample) {
    if (sample.forbidden) return sample.permitted_outcomes();
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    const Bounds codomain{question.codomain.low, question.codomain.high, false};
    std::vector<Bounds> bounds(scalars.size(), codomain);
    // Elsewhere only the codomain is promised.
    if (question.promised && !question.promised(sample.inputs)) return {bounds};
    bounds = around(question, sample.want);
    std::vector<double> want;
    const auto add = [&](const std::vector<Word>& inputs) {
        question.reference(images, inputs, want);
        std::ranges::transform(bounds, around(question, want), bounds.begin(), numeric::hull);
        return false;
    };
    internal::visit_covered_inputs(question.budget, question.signature.input_scalars(), sample.inputs, add);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (!shader::is_float(scalars[i]) || bounds[i].empty()) continue;
        bounds[i].low = std::max(bounds[i].low, codomain.low);
        bounds[i].high = std::min(bounds[i].high, codomain.high);
    }
    return {bounds};
}

}  // namespace gloam::check
