// SPDX-License-Identifier: MIT
#include "check/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "check/constant_code.hpp"
#include "check/constant_kernel.hpp"
#include "check/internal/gl_kernel.hpp"
#include "check/internal/trial.hpp"
#include "check/interpreted_kernel.hpp"
#include "check/shrink.hpp"
#include "shader/pack.hpp"
#include "shader/spirv.hpp"

namespace gloam::check {
namespace {

using Constants = shader::Variant::Constants;

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
        : question_(question),
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
        return question_.domain.draw(count, trial_.input_seed(), scenario_.size);
    }

  private:
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
    if (!lab.is_opengl()) return;
    const gl::Version version = lab.opengl().info().name.version;
    all.opengl = all.opengl_replay = lab.opengl_code(source);
    if (gl::has_compute(version)) return;
    internal::GlReplay replay{.image_words = {}, .outputs = all.outputs, .allowed = all.allowed};
    for (const Reproduction::ImageBuffer& image : all.images)
        replay.image_words.push_back(image.words.size());
    all.opengl_replay = internal::gl_replay_code(version, source, replay, lab.options().include_roots);
}

Reproduction without_verdict(const Lab& lab, const Question& question, const std::string& scenario,
                             const ImageSet& images, std::vector<Word> inputs) {
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    const Constants constants = lab.options().variant.constants;
    const shader::Source text{.name = "kernel of " + question.function,
                              .text = code_of(source, constants, inputs)};
    Reproduction all{.glsl = shader::pack({text}, {}, lab.options().include_roots),
                     .spirv = lab.compile(text),
                     .scenario = scenario,
                     .inputs = std::move(inputs),
                     .specialized = constants == Constants::specialization,
                     .outputs = question.signature.output_scalars()};
    all.assembly = shader::disassemble(all.spirv);
    std::vector<std::vector<Word>> words = image_words(source.images, images, question.function);
    for (std::size_t i = 0; i < words.size(); ++i)
        all.images.push_back({.name = source.images[i].name, .words = std::move(words[i])});
    add_opengl(lab, source, all);
    return all;
}

}  // namespace

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options) {
    const ImageScenario scenario = question.scenarios.empty() ? ImageScenario{} : question.scenarios.front();
    return without_verdict(lab, question, scenario.name, internal::images_of(scenario, options.seed),
                           question.domain.draw(1, options.seed, scenario.size).words);
}

Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options,
                       const Sample& failing) {
    const Stage stage(lab, question, scenario_of(question, failing.scenario), options);
    const ShrinkScope scope{.question = question,
                            .options = stage.judge_options(),
                            .images = stage.images(),
                            .evaluate = [&stage](std::span<const Word> inputs,
                                                 std::size_t count) { return stage.run(inputs, count); },
                            .at_once = stage.at_once()};
    const Sample smallest = shrink(scope, failing);
    Reproduction all = without_verdict(lab, question, failing.scenario, stage.images(), smallest.inputs);
    all.allowed = allowed_outputs(question, stage.images(), smallest);
    add_opengl(lab, lab.source(question.file, question.function, question.signature), all);
    all.failure = smallest;
    return all;
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

}  // namespace gloam::check
