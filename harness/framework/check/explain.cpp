// SPDX-License-Identifier: MIT
#include "check/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <ostream>
#include <stdexcept>

#include "base/text.hpp"
#include "check/answer.hpp"
#include "check/interpreted_kernel.hpp"
#include "check/scalars.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

std::string words_text(const std::vector<Scalar>& scalars, std::span<const Word> words) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < words.size(); ++i) texts.push_back(text_of(scalars[i], words[i]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

// The text of the number of a word. An integer in decimal; the bits of its value as a double would carry no
// information.
std::string number_text(const std::vector<Scalar>& scalars, std::size_t i, double number) {
    constexpr double exact = 9'007'199'254'740'992.0;
    const Scalar scalar = i < scalars.size() ? scalars[i] : Scalar::float_;
    const bool whole = std::abs(number) <= exact && number == std::floor(number);
    return shader::is_float(scalar) || !whole ? numeric::to_text(number) : fmt::format("{:.0f}", number);
}

std::string numbers_text(const std::vector<Scalar>& scalars, const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < numbers.size(); ++i) texts.push_back(number_text(scalars, i, numbers[i]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

// The bounds of each output.
std::string outcome_text(const std::vector<Scalar>& scalars, const Sample::Outcome& permitted) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < permitted.size(); ++i) {
        const numeric::Bounds& bounds = permitted[i];
        const std::string low = number_text(scalars, i, bounds.low);
        const std::string high = number_text(scalars, i, bounds.high);
        const std::string range = bounds.empty() ? "nothing but NaN"
                                  : low == high  ? low
                                                 : fmt::format("[{}, {}]", low, high);
        texts.push_back(bounds.nan && !bounds.empty() ? range + " or NaN" : range);
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

// A line with every outcome; empty if there are none.
std::string permitted_text(const std::vector<Scalar>& scalars, const std::vector<Sample::Outcome>& outcomes) {
    std::vector<std::string> texts;
    for (const Sample::Outcome& outcome : outcomes) texts.push_back(outcome_text(scalars, outcome));
    return texts.empty() ? "" : fmt::format("    permitted {}\n", fmt::join(texts, "; or "));
}

std::string sample_text(const Signature& signature, const Sample& sample) {
    return fmt::format(
        "input {} ({}{}{}): {}\n    got  {}\n    want {}\n{}    error {:.6g} ulp, {:.6g} absolute\n",
        sample.index, name_of(sample.input_class), sample.scenario.empty() ? "" : ", images ",
        sample.scenario, sample.values, words_text(signature.output_scalars(), sample.got),
        numbers_text(signature.output_scalars(), sample.want),
        permitted_text(signature.output_scalars(), sample.permitted_outcomes()), sample.ulp, sample.absolute);
}

}  // namespace

std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs) {
    std::vector<std::string> texts;
    std::size_t first = 0;
    for (const shader::Parameter& p : signature.parameters) {
        if (p.direction == shader::Direction::out) continue;
        const std::vector<Scalar> scalars = scalars_of(p.type);
        if (scalars.empty()) continue;  // a sampler
        const std::vector<Word> words(inputs.begin() + static_cast<std::ptrdiff_t>(first),
                                      inputs.begin() + static_cast<std::ptrdiff_t>(first + scalars.size()));
        const std::string values = words_text(scalars, words);
        const std::string what = shader::to_glsl(p.type) + (p.global ? " " + p.name : "");
        texts.push_back(
            fmt::format(fmt::runtime(shader::scalar_count(p.type) > 1 ? "{} ({})" : "{} {}"), what, values));
        first += scalars.size();
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string describe_outputs(const Signature& signature, const std::vector<Word>& outputs) {
    return words_text(signature.output_scalars(), outputs);
}

std::string describe(const Signature& signature, const Answer& answer) {
    const std::string limit =
        answer.verdict == Verdict::rules ? "what Vulkan's precision rules permit" : to_text(answer.budget);
    std::string text = fmt::format("{} ({}): {} of {} inputs outside {}\n", answer.function, answer.file,
                                   answer.outside(), answer.inputs(), limit);
    if (!answer.fault.empty()) text += fmt::format("  {}\n", answer.fault);
    for (std::size_t i = 0; i < input_class_count; ++i) {
        const ClassCount& count = answer.classes[i];
        if (count.inputs == 0) continue;
        text += fmt::format("  {:<10} {:>9} inputs {:>9} outside", name_of(static_cast<InputClass>(i)),
                            count.inputs, count.outside);
        if (count.recorded > 0) text += fmt::format(" {:>9} only recorded", count.recorded);
        if (count.open > 0) text += fmt::format(" {:>9} open", count.open);
        text += "\n";
    }
    if (answer.worst) text += "  worst " + sample_text(signature, *answer.worst);
    for (const auto& first : answer.first_outside) {
        if (first && (!answer.worst || first->index != answer.worst->index))
            text += "  first " + sample_text(signature, *first);
    }
    return text;
}

void describe_samples(const Signature& signature, Answer& answer) {
    const auto describe_one = [&signature](std::optional<Sample>& sample) {
        if (sample && sample->values.empty()) sample->values = describe_inputs(signature, sample->inputs);
    };
    describe_one(answer.worst);
    describe_one(answer.first_unbounded);
    for (std::optional<Sample>& first : answer.first_outside) describe_one(first);
}

std::ostream& operator<<(std::ostream& stream, const Answer& answer) {
    if (!answer.story.empty()) return stream << answer.story;
    const std::string why = answer.ran() ? answer.not_judged_because() : answer.error;
    return stream << fmt::format("{} ({}): {} of {} inputs outside{}{}\n", answer.function, answer.file,
                                 answer.outside(), answer.inputs(), why.empty() ? "" : ": ", why);
}

namespace {

using interpreter::Explained;

constexpr const char* kernel_name = "kernel";
constexpr std::uint64_t most_instructions = 500'000;  // of one explanation, which stores all of them

shader::Function function_of(const shader::CompileOptions& options, const std::string& file,
                             const std::string& name) {
    const shader::Source probe{.name = "signature of " + file,
                               .text = fmt::format("#version 450\n#include \"{}\"\n", file)};
    for (const shader::Function& function : shader::SpirvCache().functions(probe, options))
        if (function.name == name && function.defined) return function;
    throw std::invalid_argument(fmt::format("{}: no function {}", file, name));
}

// What is known of a value, whatever operation made it.
ExplainedStep explained(const interpreter::Value<Explained>& value, const numeric::FloatFormat& format) {
    if (!value.is_number()) return {.value = static_cast<double>(value.bits()), .whole = true};
    const Explained x = value.number();
    ExplainedStep one{.value = x.value,
                      .exact = x.exact,
                      .permitted = x.permitted.bounds(),
                      .error = x.value - x.exact,
                      .local = x.local,
                      .ulps = numeric::ulp_error(x.value, x.exact, format)};
    if (std::isnan(one.error)) one.error = 0.0;  // one infinity equals the other
    return one;
}

// The same, or why it is undefined.
ExplainedStep explained(interpreter::Machine<Explained>& machine, const interpreter::Value<Explained>& value,
                        const numeric::FloatFormat& format) {
    const auto why = machine.why_undefined(value);
    if (!why) return explained(value, format);
    return {.permitted = numeric::Bounds::anything(), .undefined = why->cause};
}

void append(const interpreter::Step<Explained>& step, interpreter::Machine<Explained>& machine,
            std::vector<ExplainedStep>& steps) {
    if (step.place.file.empty() || step.place.file == kernel_name) return;
    for (std::size_t k = 0; k < step.results.size(); ++k) {
        const interpreter::Value<Explained>& result = step.results[k];
        if (!result.is_number() && !result.is_bits() && !result.is_undefined()) continue;
        ExplainedStep one = explained(machine, result, step.format);
        one.file = step.place.file;
        one.line = step.place.line;
        one.function = step.place.function;
        one.operation = step.operation();
        one.component = k;
        steps.push_back(std::move(one));
    }
}

// By how much the error of each step, in ULP, rises above the errors of all steps before it. It can decrease
// in between.
std::vector<double> rises_of(const std::vector<ExplainedStep>& steps) {
    std::vector<double> rises;
    double highest = 0.0;
    for (const ExplainedStep& step : steps) {
        if (step.whole) {
            rises.push_back(-1.0);
            continue;
        }
        rises.push_back(std::max(step.ulps - highest, 0.0));
        highest = std::max(highest, step.ulps);
    }
    return rises;
}

std::size_t worst_of(const std::vector<ExplainedStep>& steps) {
    const std::vector<double> rises = rises_of(steps);
    const auto most = std::ranges::max_element(rises);
    return most == rises.end() || *most <= 0.0 ? steps.size()
                                               : static_cast<std::size_t>(most - rises.begin());
}

// The `most` steps at which the error rises most, in their order.
std::vector<std::size_t> telling_steps(const std::vector<ExplainedStep>& steps, std::size_t most) {
    std::vector<std::size_t> order(steps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (steps.size() <= most) return order;
    const std::vector<double> rises = rises_of(steps);
    std::ranges::sort(order, [&rises](std::size_t a, std::size_t b) {
        return rises[a] != rises[b] ? rises[a] > rises[b] : a > b;
    });
    order.resize(most);
    std::ranges::sort(order);
    return order;
}

std::string permitted_text(const numeric::Bounds& bounds) {
    if (bounds.is_anything()) return "anything";
    if (bounds.empty()) return "NaN";
    return fmt::format("[{:.9g}, {:.9g}]{}", bounds.low, bounds.high, bounds.nan ? " or NaN" : "");
}

// The sign of a NaN means nothing.
std::string value_text(double value, int digits) {
    return std::isnan(value) ? "NaN" : fmt::format("{:.{}g}", value, digits);
}

std::string share_text(double error) {
    return std::isnan(error) ? "NaN" : fmt::format("{:.2e}", error);
}

std::string place_of(const ExplainedStep& step) {
    return fmt::format("{}:{}", base::one_line(std::filesystem::path(step.file).filename().string()),
                       step.line);
}

constexpr std::string_view line_format = "{:<34} {:<24} {:>15} {:>22} {:>10} {:>11} {:>11}  {}\n";

// Bits of an integer operation. SPIR-V's additions have no sign: what may be negative is shown as both.
std::string whole_text(const ExplainedStep& step) {
    const auto bits = static_cast<Word>(step.value);
    const std::string& name = step.operation;
    for (const char* decides :
         {"Equal", "LessThan", "GreaterThan", "Logical", "OpAny", "OpAll", "OpIsNan", "OpIsInf"})
        if (name.find(decides) != std::string::npos) return bits != 0 ? "true" : "false";
    return bits >> 31U == 0 ? fmt::format("{}", bits)
                            : fmt::format("{} or {}", bits, static_cast<std::int32_t>(bits));
}

std::string line_of(const ExplainedStep& step, bool is_worst) {
    const std::string place = place_of(step) + " " + step.function;
    const std::string operation = step.component == 0
                                      ? step.operation
                                      : fmt::format("{} .{}", step.operation, "xyzw"[step.component % 4]);
    if (!step.undefined.empty())
        return fmt::format(line_format, place, operation, "undefined", "", "", "", "", step.undefined);
    if (step.whole) return fmt::format("{:<34} {:<24} {:>15}\n", place, operation, whole_text(step));
    return fmt::format(line_format, place, operation, value_text(step.value, 9), value_text(step.exact, 17),
                       fmt::format("{:.3g}", step.ulps), share_text(step.local), share_text(step.inherited()),
                       permitted_text(step.permitted) + (is_worst ? "  <-- most of the error" : ""));
}

// A value that no operation of floats made; numbers without their bits.
std::string bits_text(Scalar scalar, Word word) {
    if (scalar == Scalar::float_) return value_text(double{from_word<float>(word)}, 9);
    return scalar == Scalar::uint_ ? fmt::format("{}", word) : text_of(scalar, word);
}

// "result 0.5 (0.50000001 in double, permitted [0.49999997, 0.50000003])", lists for a vector and for out
// parameters.
std::string result_line(const Explanation& all) {
    std::vector<std::string> values;
    std::vector<std::string> exact;
    std::vector<std::string> permitted;
    bool calculated = false;
    for (std::size_t i = 0; i < all.scalars.size() && i < all.result.size(); ++i) {
        const ExplainedStep& one = all.result[i];
        const bool defined = one.undefined.empty();
        const std::string bits = !defined    ? "undefined"
                                 : one.whole ? bits_text(all.scalars[i], static_cast<Word>(one.value))
                                             : "";
        values.push_back(one.whole || !defined ? bits : value_text(one.value, 9));
        exact.push_back(one.whole || !defined ? bits : value_text(one.exact, 17));
        permitted.push_back(one.whole ? bits : permitted_text(one.permitted));
        calculated = calculated || (!one.whole && defined);
    }
    if (values.empty()) return "";
    if (!calculated) return fmt::format("result {}\n", fmt::join(values, ", "));
    return fmt::format("result {} ({} in double, permitted {})\n", fmt::join(values, ", "),
                       fmt::join(exact, ", "), fmt::join(permitted, ", "));
}

// Where the error grows most, and where the first NaN arises.
std::string last_lines(const Explanation& explanation) {
    const std::vector<ExplainedStep>& steps = explanation.steps;
    std::string text = "no operation adds an error\n";
    if (explanation.worst < steps.size()) {
        const ExplainedStep& worst = steps[explanation.worst];
        const bool cancels = std::abs(worst.inherited()) > std::abs(worst.local);
        text = fmt::format(
            "the error in ULP grows most at {}, {}: {}\n", place_of(worst), worst.operation,
            cancels ? "the result is small beside its operands, whose errors it keeps" : "its own rounding");
    }
    const auto undefined =
        std::ranges::find_if(steps, [](const auto& step) { return !step.undefined.empty(); });
    if (undefined != steps.end())
        text += fmt::format("undefined at {}: {}\n", place_of(*undefined), undefined->undefined);
    const auto nan = std::ranges::find_if(steps, [](const auto& step) { return std::isnan(step.value); });
    if (nan == steps.end()) return text;
    return text + fmt::format("the first NaN is the result of {}, {}\n", place_of(*nan), nan->operation);
}

}  // namespace

KernelModule lined_module(const shader::CompileOptions& options, const KernelSource& source,
                          const shader::SpirvCache& cache) {
    shader::CompileOptions with_lines = options;
    with_lines.lines = true;
    with_lines.stage = stage_of(source.team);
    const Signature signature{.result = source.function.result, .parameters = source.function.parameters};
    return {.spirv = cache.compile({.name = kernel_name, .text = kernel_code(source)}, with_lines),
            .input_words = signature.input_words(),
            .output_words = signature.output_words(),
            .images = source.images,
            .team = source.team};
}

KernelModule lined_module(const Lab& lab, const KernelSource& source) {
    shader::CompileOptions options = lab.compile_options();
    options.variant = {};
    KernelModule module = lined_module(options, source, shader_cache(lab.options()));
    module.subgroup_size = std::max(lab.info().subgroup_size, 1U);
    return module;
}

KernelModule lined_module(const Lab& lab, const Question& question) {
    return lined_module(lab, lab.source(question.file, question.function, question.signature));
}

Explanation explain(InterpretedKernel<Explained>& kernel, std::span<const Word> input,
                    numeric::Paths::Gaps gaps) {
    kernel.machine().set_limit(most_instructions);
    Explanation all;
    const auto run = [&] {
        kernel.run(input, [&](const interpreter::Step<Explained>& step) {
            append(step, kernel.machine(), all.steps);
        });
        for (std::size_t word = 0; word < kernel.output_words(); ++word)
            all.result.push_back(explained(kernel.machine(), kernel.output(word), numeric::float32));
        throw numeric::Paths::Enough{};
    };
    // The path is that of float32. Where only intervals leave a branch undecided, the first way is taken.
    (void)numeric::Paths::explore(numeric::float32, 1, run, gaps);
    all.worst = worst_of(all.steps);
    return all;
}

Explanation explain(const shader::CompileOptions& options, const KernelSource& source,
                    std::span<const Word> input, const ImageSet& images) {
    const KernelModule module = lined_module(options, source);
    if (input.size() != module.input_words)
        throw std::invalid_argument(fmt::format("{} takes {} values, got {}",
                                                shader::to_glsl(source.function), module.input_words,
                                                input.size()));
    const interpreter::Program program(module.spirv);
    const std::vector<std::vector<Word>> words = image_words(module.images, images, source.function.name);
    InterpretedKernel<Explained> kernel(program, module, words);
    Explanation all = explain(kernel, input);
    all.scalars = Signature{.result = source.function.result, .parameters = source.function.parameters}
                      .output_scalars();
    return all;
}

Explanation explain(const shader::CompileOptions& options, const std::string& file,
                    const std::string& function, std::span<const Word> input) {
    return explain(options, {.file = file, .function = function_of(options, file, function), .images = {}},
                   input);
}

std::string to_text(const Explanation& explanation, std::size_t most) {
    const std::vector<ExplainedStep>& steps = explanation.steps;
    std::string text = fmt::format(line_format, "line", "operation", "float32", "double", "error ulp",
                                   "by itself", "inherited", "permitted");
    const std::vector<std::size_t> shown = telling_steps(steps, most);
    for (const std::size_t i : shown) text += line_of(steps[i], i == explanation.worst);
    if (shown.size() < steps.size())
        text += fmt::format("({} of {} operations)\n", shown.size(), steps.size());
    return text + result_line(explanation) + last_lines(explanation);
}

}  // namespace gloam::check
