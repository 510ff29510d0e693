// SPDX-License-Identifier: MIT
#include "judge/session.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <utility>

#include "base/threads.hpp"
#include "judge/explain.hpp"
#include "judge/internal/budget_judge.hpp"
#include "judge/interpretation.hpp"
#include "module/spirv.hpp"
#include "subject/kernel_code.hpp"

namespace gloam::judge {

using namespace subject;

Session::Session(const Lab& lab, const Question& question, KernelCore kernel, ImageScenario scenario,
                 std::uint64_t seed)
    : lab_(lab),
      question_(question),
      kernel_(std::move(kernel)),
      has_constants_(lab.options().variant.constants != module::Variant::Constants::none),
      scenario_(std::move(scenario)),
      input_seed_(input_seed_of(question, scenario_, seed)),
      images_(images_of(scenario_, seed)),
      options_{
          .edges = !question.only_rules && !lab.options().variant.relaxed,
          .nan = lab.keeps_nan() && lab.options().variant.constants != module::Variant::Constants::literals,
          .criterion = question.criterion_in(lab.options().variant)} {}

Session::Evaluated Session::run(Domain::Inputs inputs, Answer& answer) const {
    if (!options_.nan) internal::set_positive_zeros(inputs.words, question_.signature.input_scalars());
    KernelCore::Result outputs;
    try {
        outputs = kernel_.run(inputs.words, inputs.count(), images_);
    } catch (const backend::UndefinedResult&) {
        outputs = run_each(inputs);
    }
    lab_.require_silent_validation();
    if (outputs.fault && answer.fault.empty()) {
        answer.fault = to_text(*outputs.fault);
        answer.reason = Reason::fault;
    }
    if (!has_constants_) return {std::move(inputs), std::move(outputs)};
    KernelCore::Result folded = run_constants(inputs);
    lab_.require_silent_validation();
    const std::size_t width = kernel_.output_words();
    const std::vector<module::Scalar> scalars = question_.signature.output_scalars();
    for (std::size_t i = 0; i < inputs.count(); ++i)
        if (!same_bits(scalars, std::span(outputs.outputs).subspan(i * width, width),
                       std::span(folded.outputs).subspan(i * width, width)))
            ++answer.differs;
    return {std::move(inputs), std::move(folded)};
}

namespace {

// Of an input. lavapipe ends all loops of a group of invocations after 65,535 rounds of one of them, and a
// round takes two instructions at least: such an input stays out of the verdict, and away from the others.
constexpr std::uint64_t most_long = 2 * 65'535;
constexpr std::uint64_t least_long = 4'096;      // the same where most inputs take many
constexpr std::uint64_t most_all = 400'000'000;  // of all inputs, about

bool has_loop(const KernelModule& module) {
    return module::has_loop(module.spirv) || (!module.before.empty() && module::has_loop(module.before));
}

}  // namespace

// Rounded to float32 or not, a loop may take another number of rounds.
std::vector<char> Session::long_runs(const Domain::Inputs& inputs, std::uint64_t limit) const {
    const Decoded decoded = decode({std::make_shared<const KernelModule>(kernel_.module())}, images_);
    const DecodedModule& part = decoded.front();
    std::vector<char> is_long(inputs.count(), 0);
    const auto mark = [&](auto& kernel, std::size_t i) {
        kernel.machine().set_limit(limit);
        try {
            kernel.run(inputs.row(i));
        } catch (const interpreter::Error& error) {
            if (error.kind() == interpreter::Error::Kind::too_many_steps) is_long[i] = 1;
        }
    };
    const std::vector<base::Range> shares = base::shares_of(inputs.count(), base::processors());
    base::for_each_index(shares.size(), 0, [&](std::size_t share) {
        InterpretedKernel<float> floats(part.program, *part.module, part.images);
        InterpretedKernel<double> doubles(part.program, *part.module, part.images);
        for (std::size_t i = shares[share].begin; i < shares[share].end; ++i) {
            mark(floats, i);
            if (is_long[i] == 0) mark(doubles, i);
        }
    });
    return is_long;
}

Domain::Inputs Session::without_long_runs(const Domain::Inputs& inputs, Answer& answer) const {
    const KernelModule& module = kernel_.module();
    if (question_.reference || module.spirv.empty() || !has_loop(module)) return inputs;
    constexpr std::size_t probes = 64;
    std::uint64_t limit = most_long;
    std::vector<char> is_long;
    try {
        const std::size_t every = std::max<std::size_t>(inputs.count() / probes, 1);
        const std::vector<char> probed =
            long_runs(inputs.where([&](std::size_t i) { return i % every == 0; }), most_long);
        const auto shown = static_cast<std::uint64_t>(std::ranges::count(probed, 1));
        const std::uint64_t all =
            shown * most_long * inputs.count() / std::max<std::size_t>(probed.size(), 1);
        if (all > most_all) limit = std::max(least_long, most_long * most_all / all);
        is_long = long_runs(inputs, limit);
    } catch (const interpreter::Error&) {  // an unknown instruction: nothing will be judged
        return inputs;
    }
    const std::vector<module::Scalar> scalars = question_.signature.input_scalars();
    for (std::size_t i = 0; i < inputs.count(); ++i)
        if (is_long[i] != 0)
            answer.add_undefined(internal::class_of(inputs.row(i), scalars, inputs.branch[i]),
                                 NoResult::too_long, fmt::format("more than {} instructions", limit));
    return inputs.where([&](std::size_t i) { return is_long[i] == 0; });
}

KernelCore::Result Session::run_each(const Domain::Inputs& inputs) const {
    constexpr Word undefined = 0xdeadbeefU;
    KernelCore::Result all;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        try {
            const KernelCore::Result one = kernel_.run(inputs.row(i), 1, images_);
            all.outputs.insert(all.outputs.end(), one.outputs.begin(), one.outputs.end());
            all.modules = one.modules;
            if (one.fault && !all.fault) (all.fault = one.fault)->input = i;
        } catch (const backend::UndefinedResult&) {
            all.outputs.insert(all.outputs.end(), kernel_.output_words(), undefined);
        }
    }
    return all;
}

KernelCore::Result Session::run_constants(const Domain::Inputs& inputs) const {
    constexpr std::size_t of_a_module = 4;
    KernelCore::Result all;
    for (std::size_t first = 0; first < inputs.count(); first += of_a_module) {
        const std::size_t count = std::min(of_a_module, inputs.count() - first);
        const auto words = std::span(inputs.words).subspan(first * inputs.width, count * inputs.width);
        KernelCore::Result part = lab_.constant_kernel(source(), words, count).run({}, count, images_);
        all.outputs.insert(all.outputs.end(), part.outputs.begin(), part.outputs.end());
        all.modules.insert(all.modules.end(), part.modules.begin(), part.modules.end());
        if (!part.fault) continue;
        part.fault->input += first;
        part.fault->count += all.fault ? all.fault->count : 0;
        all.fault = part.fault;
    }
    return all;
}

void Session::judge(const Evaluated& evaluated, Answer& answer, std::span<double> fractions) const {
    JudgeOptions options = options_;
    options.modules = evaluated.result.modules;
    answer.merge(judge::judge(question_, options, evaluated.inputs, evaluated.result.outputs, images_,
                              scenario_.name, fractions));
}

std::optional<Sample> Session::first_failing(std::span<const std::vector<Word>> inputs) const {
    const std::size_t at_once = has_constants_ ? most_constants : std::size_t{1} << 20U;
    for (; !inputs.empty(); inputs = inputs.subspan(std::min(at_once, inputs.size()))) {
        Evaluated some{.inputs = {.width = kernel_.input_words()}, .result = {}};
        for (const std::vector<Word>& words : inputs.first(std::min(at_once, inputs.size())))
            some.inputs.add(words);
        some.result = has_constants_ ? run_constants(some.inputs)
                                     : kernel_.run(some.inputs.words, some.inputs.count(), images_);
        Answer answer;
        judge(some, answer);
        std::optional<Sample> first;
        for (const auto& sample : answer.first_outside)
            if (sample && (!first || sample->index < first->index)) first = sample;
        if (first) return first;
    }
    return std::nullopt;
}

std::uint64_t input_seed_of(const Question& question, const ImageScenario& scenario, std::uint64_t seed) {
    return seed ^ numeric::hash_of(question.function + scenario.name);
}

ImageSet images_of(const ImageScenario& scenario, std::uint64_t seed) {
    numeric::Random random(seed ^ numeric::hash_of(scenario.name));
    return scenario.make ? scenario.make(scenario.size, random) : ImageSet{};
}

Domain domain_of(const Lab& lab, const Question& question, const KernelSource& source) {
    const module::Spirv module =
        lab.cache().compile({.name = "kernel of " + question.function, .text = kernel_code(source)},
                            {.stage = stage_of(source.team),
                             .include_roots = lab.options().include_roots,
                             .variant = {}});  // the same inputs in every variant
    return question.domain.and_numbers(question.signature, module::float_constants(module));
}

namespace {

// Where the module in double is as far from the reference as the result.
std::string reference_text(const Question& question, const Sample& sample, const Explanation& all) {
    const std::vector<module::Scalar> scalars = question.signature.output_scalars();
    for (std::size_t i = 0; question.reference && i < std::min(all.result.size(), scalars.size()); ++i) {
        const double got = number_at(scalars[i], sample.got[i]);
        const double exact = all.result[i].exact;
        if (module::is_float(scalars[i]) && std::abs(exact - sample.want[i]) > std::abs(exact - got))
            return fmt::format(
                "  in double the function gives {:.9g}, too, and the reference {:.9g}: the formula or the "
                "reference is wrong, not the rounding\n",
                exact, sample.want[i]);
    }
    return {};
}

std::string explanation_of(const Lab& lab, const Question& question, const KernelSource& source,
                           const Sample& sample, std::uint64_t seed) {
    try {
        const Explanation all = explain(lab.judged_options(), source, sample.inputs,
                                        images_of(question.scenario_of(sample.scenario), seed));
        return (sample.forbidden ? younger_rules(all, lab.info().api_version) : "") +
               reference_text(question, sample, all) +
               fmt::format("  the worst input{}, operation by operation, rounded correctly:\n",
                           lab.options().variant.steps.empty() ? "" : " in the module before the steps") +
               to_text(all);
    } catch (const std::exception& error) {  // a shader that the interpreter cannot run still gets a story
        return fmt::format("  the worst input cannot be explained: {}\n", error.what());
    }
}

// Why a result has an infinite error although it is finite. NaN is outside every codomain, and says so
// itself.
std::string codomain_text(const Question& question, const Sample& sample) {
    const std::vector<module::Scalar> scalars = question.signature.output_scalars();
    const Codomain& range = question.codomain;
    for (std::size_t i = 0; i < sample.got.size(); ++i) {
        if (scalars[i] == module::Scalar::bool_) continue;
        const double value = number_at(scalars[i], sample.got[i]);
        if (value < range.low || value > range.high)
            return fmt::format("  the worst result is outside the codomain [{}, {}]\n", range.low,
                               range.high);
    }
    return {};
}

// Whether the device may return this result for the module that it was given itself.
bool is_right(const Lab& lab, const Question& question, KernelModule given, const Sample& sample,
              std::uint64_t seed) {
    if (lab.options().variant.constants != module::Variant::Constants::none)
        given = lab.constant_kernel(*given.source, sample.inputs, 1).module();
    given.before.clear();
    const Decoded decoded = decode({std::make_shared<const KernelModule>(std::move(given))},
                                   images_of(question.scenario_of(sample.scenario), seed));
    Interpretation rules(decoded, question.signature);
    const InputRow input{.words = sample.inputs};
    return rules.is_exact(input, sample.got) || rules.is_permitted(input, sample.got);
}

// Of a result that the module before a compiler forbids: whether the compiler or the device is at fault.
std::string culprit_text(const Lab& lab, const Question& question, const KernelModule& given,
                         const Sample& sample, std::uint64_t seed) {
    if (given.before.empty() || !sample.forbidden) return {};
    const module::Variant& variant = lab.options().variant;
    const std::string compiler = variant.steps.empty() ? "SPIRV-Tools" : "the compiler's step";
    try {
        if (is_right(lab, question, given, sample, seed))
            return fmt::format(
                "  the module that the device was given permits the worst result, and the one before "
                "forbids it: {} is at fault, not the device (variant {})\n",
                compiler, variant.name);
        return "  the module that the device was given forbids the worst result, too: the device is at "
               "fault\n";
    } catch (const interpreter::Error&) {  // it has an instruction that the interpreter does not know
        return {};
    }
}

}  // namespace

void complete(Answer& answer, const Lab& lab, const Question& question, const KernelModule& given,
              std::uint64_t seed) {
    answer.variant = lab.options().variant.name;
    if (!answer.failed()) return;
    answer.story = describe(question.signature, answer);
    if (answer.worst && !answer.rules_alone()) answer.story += codomain_text(question, *answer.worst);
    if (answer.outside() == 0 || !answer.worst) return;
    answer.story += culprit_text(lab, question, given, *answer.worst, seed);
    answer.story += explanation_of(lab, question, *given.source, *answer.worst, seed);
}

}  // namespace gloam::judge
