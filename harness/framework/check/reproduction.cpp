// SPDX-License-Identifier: MIT
#include "check/reproduction.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "check/internal/budget_judge.hpp"
#include "check/internal/kernel_text.hpp"
#include "check/internal/trial.hpp"
#include "check/interpreted_kernel.hpp"
#include "check/kernel_code.hpp"
#include "numeric/numbers.hpp"
#include "shader/pack.hpp"
#include "shader/spirv.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;
using Words = std::vector<Word>;

constexpr int significand_bits = 23;
constexpr Word sign_bit = 0x80000000U;

std::size_t float_complexity(Word word) {
    const Word magnitude = word & ~sign_bit;
    const std::size_t sign = word == magnitude ? 0 : 1;
    if (magnitude == 0) return sign;
    const auto value = std::bit_cast<float>(magnitude);
    if (!std::isfinite(value)) return 200 + sign;  // more complex than any number
    const Word significand = magnitude & ((1U << significand_bits) - 1U);
    const int bits = significand == 0 ? 0 : significand_bits - std::countr_zero(significand);
    const int exponent = std::abs(static_cast<int>(magnitude >> significand_bits) - 127);
    return 2 + sign + 2 * static_cast<std::size_t>(bits) + static_cast<std::size_t>(exponent);
}

std::size_t word_complexity(Word word, Scalar scalar) {
    if (scalar == Scalar::float_) return float_complexity(word);
    const bool negative = scalar == Scalar::int_ && (word & sign_bit) != 0;
    const Word magnitude = negative ? ~word + 1U : word;
    // By bit width, then by the number of set bits: 4 is simpler than 5, and 3 is simpler than both.
    return (negative ? 1U : 0U) + static_cast<std::size_t>(4 * std::bit_width(magnitude)) +
           static_cast<std::size_t>(std::popcount(magnitude));
}

void add_float_candidates(Word word, std::set<Word>& candidates) {
    const auto value = std::bit_cast<float>(word);
    for (const float simple :
         {0.0F, 1.0F, -1.0F, 0.5F, -0.5F, 2.0F, -2.0F, 3.0F, 0.25F, 4.0F, 10.0F, 100.0F}) {
        candidates.insert(to_word(simple));
    }
    candidates.insert(word ^ sign_bit);
    if (!std::isfinite(value)) return;
    for (int kept = 0; kept < significand_bits; ++kept) {
        const Word step = 1U << (significand_bits - kept);
        candidates.insert(word & ~(step - 1U));                // towards zero
        candidates.insert((word + step - 1U) & ~(step - 1U));  // away from zero
    }
    candidates.insert(to_word(std::trunc(value)));
    const int exponent = value == 0.0F ? 0 : std::ilogb(value);
    for (int step = std::abs(exponent); step > 0; step /= 2) {
        candidates.insert(to_word(std::ldexp(value, exponent > 0 ? -step : step)));
    }
    if (exponent != 0) candidates.insert(to_word(std::ldexp(value, exponent > 0 ? -1 : 1)));
}

void add_integer_candidates(Word word, Scalar scalar, std::set<Word>& candidates) {
    if (scalar == Scalar::bool_) {
        candidates.insert(0U);
        return;
    }
    for (Word simple = 0; simple <= 8; ++simple) candidates.insert(simple);
    const bool negative = scalar == Scalar::int_ && (word & sign_bit) != 0;
    const Word magnitude = negative ? ~word + 1U : word;
    const auto add = [&](Word smaller) { candidates.insert(negative ? ~smaller + 1U : smaller); };
    if (negative) candidates.insert(magnitude);
    for (int shift = 1; shift < 32; ++shift) {
        add(magnitude >> shift);
        add(magnitude & ~((1U << shift) - 1U));
        add(magnitude - (magnitude >> shift));
    }
    if (magnitude > 0) add(magnitude - 1U);
}

class Shrinker {
  public:
    explicit Shrinker(const ShrinkScope& scope)
        : scope_(scope), scalars_(scope.question.signature.input_scalars()) {}

    Sample run(const Sample& failing) {
        std::optional<Sample> best = first_failing(std::vector<Words>{failing.inputs});
        if (!best) throw std::invalid_argument("shrink: the input does not fail: there is nothing to shrink");
        while (const auto simpler = first_failing(simpler_inputs(scope_.question, best->inputs)))
            best = simpler;
        best->scenario = failing.scenario;
        best->index = failing.index;
        return *best;
    }

  private:
    // The first input that fails, if any.
    [[nodiscard]] std::optional<Sample> first_failing(const std::vector<Words>& inputs) const {
        for (std::size_t first = 0; first < inputs.size(); first += scope_.at_once) {
            const std::size_t count = std::min(scope_.at_once, inputs.size() - first);
            if (const auto found = first_failing(std::span(inputs).subspan(first, count))) return found;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Sample> first_failing(std::span<const Words> inputs) const {
        Domain::Inputs batch;
        batch.width = scalars_.size();
        batch.branch.assign(inputs.size(), false);
        for (const Words& words : inputs) batch.words.insert(batch.words.end(), words.begin(), words.end());
        const KernelCore::Result result = scope_.evaluate(batch.words, inputs.size());
        JudgeOptions options = scope_.options;
        options.modules = result.modules;
        const Answer answer = judge(scope_.question, options, batch, result.outputs, scope_.images);
        std::optional<Sample> first;
        for (const auto& sample : answer.first_outside) {
            if (sample && (!first || sample->index < first->index)) first = sample;
        }
        return first;
    }

    const ShrinkScope& scope_;
    std::vector<Scalar> scalars_;
};

}  // namespace

std::size_t complexity(std::span<const Word> input, const std::vector<Scalar>& scalars) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < input.size(); ++i) sum += word_complexity(input[i], scalars[i]);
    return sum;
}

std::vector<Words> simpler_inputs(const Question& question, const Words& input) {
    const std::vector<Scalar> scalars = question.signature.input_scalars();
    std::set<Words> found;
    for (std::size_t i = 0; i < input.size(); ++i) {
        std::set<Word> candidates;
        if (scalars[i] == Scalar::float_) {
            add_float_candidates(input[i], candidates);
        } else {
            add_integer_candidates(input[i], scalars[i], candidates);
        }
        for (const Word candidate : candidates) {
            Words alone = input;
            alone[i] = candidate;
            found.insert(std::move(alone));
            Words together = input;
            for (std::size_t j = 0; j < input.size(); ++j)
                if (scalars[j] == scalars[i] && input[j] == input[i]) together[j] = candidate;
            found.insert(std::move(together));
        }
    }
    const std::size_t now = complexity(input, scalars);
    std::vector<Words> simpler;
    for (const Words& words : found)
        if (complexity(words, scalars) < now && question.domain.holds(words, input)) simpler.push_back(words);
    std::ranges::stable_sort(simpler, {}, [&](const Words& words) { return complexity(words, scalars); });
    return simpler;
}

Sample shrink(const ShrinkScope& scope, const Sample& failing) {
    return Shrinker(scope).run(failing);
}

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
    const auto language = lab.language();
    if (!language) return;
    all.opengl = all.opengl_replay = internal::gl_kernel_code(*language, source, lab.options().include_roots);
    if (internal::has_compute(*language)) return;
    internal::GlReplay replay{.image_words = {}, .outputs = all.outputs, .allowed = all.allowed};
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
    Reproduction all{.glsl = shader::pack({text}, {.stage = in_stage.stage}, lab.options().include_roots),
                     .spirv = lab.compile(text, in_stage),
                     .team = source.team,
                     .scenario = scenario,
                     .inputs = std::move(inputs),
                     .specialized = constants == Constants::specialization,
                     .outputs = question.signature.output_scalars()};
    all.assembly = shader::disassemble(all.spirv);
    std::vector<std::vector<Word>> words = image_words(source.images, images, question.function);
    for (std::size_t i = 0; i < words.size(); ++i)
        all.images.push_back({.name = source.images[i].name,
                              .words = std::move(words[i]),
                              .bound = !source.images[i].is_prototype()});
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

namespace {

using numeric::Bounds;
using shader::Scalar;

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
            if (scalars[i] != Scalar::float_) {
                bounds.push_back(Bounds::point(want[i]));
                continue;
            }
            const double at = question.budget.of_largest_component ? largest : want[i];
            bounds.push_back(around(want[i], numeric::ulp_size(at), question.budget));
        }
    }
    return bounds;
}

}  // namespace

std::vector<Bounds> allowed_outputs(const Question& question, const ImageSet& images, const Sample& sample) {
    if (!sample.permitted.empty()) return sample.permitted;
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    const Bounds codomain{question.codomain.low, question.codomain.high, false};
    std::vector<Bounds> bounds(scalars.size(), codomain);
    // Elsewhere only the codomain is promised.
    if (question.promised && !question.promised(sample.inputs)) return bounds;
    bounds = around(question, sample.want);
    std::vector<double> want;
    const auto add = [&](const std::vector<Word>& inputs) {
        question.reference(images, inputs, want);
        std::ranges::transform(bounds, around(question, want), bounds.begin(), numeric::hull);
        return false;
    };
    internal::visit_covered_inputs(question.budget, question.signature.input_scalars(), sample.inputs, add);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (scalars[i] != Scalar::float_ || bounds[i].empty()) continue;
        bounds[i].low = std::max(bounds[i].low, codomain.low);
        bounds[i].high = std::min(bounds[i].high, codomain.high);
    }
    return bounds;
}

}  // namespace gloam::check
