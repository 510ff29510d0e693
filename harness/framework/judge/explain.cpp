// SPDX-License-Identifier: MIT
#include "judge/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <ostream>
#include <stdexcept>

#include "base/text.hpp"
#include "numeric/numbers.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

using interpreter::Explained;
using module::Scalar;

constexpr const char* kernel_name = "kernel";
constexpr std::uint64_t most_instructions = 500'000;  // of one explanation, which stores all of them
constexpr std::size_t most_outcomes = 4;              // of an operation: an angle is pi or -pi

// What is known of a value, whatever operation made it, or why it is undefined.
ExplainedStep explained(interpreter::Machine<Explained>& machine, const interpreter::Value<Explained>& value,
                        const numeric::FloatFormat& format) {
    if (const auto why = machine.why_undefined(value)) {
        const bool is_ours = why->place.file == kernel_name;
        return {.file = is_ours ? "" : why->place.file,
                .line = is_ours ? 0 : why->place.line,
                .permitted = numeric::Bounds::anything(),
                .undefined = why->cause};
    }
    if (!value.is_number())
        return {.value = static_cast<double>(value.bits()), .kind = ExplainedStep::Kind::integer};
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
        if (interpreter::gives_truth(step.opcode)) one.kind = ExplainedStep::Kind::truth;
        one.component = k;
        steps.push_back(std::move(one));
    }
}

// Adds what another run of the same path permits.
void add_outcomes(std::vector<ExplainedStep> steps, std::vector<ExplainedStep>& all) {
    if (all.empty()) {
        all = std::move(steps);
        return;
    }
    for (std::size_t i = 0; i < std::min(steps.size(), all.size()); ++i) {
        if (steps[i].operation != all[i].operation) continue;
        const numeric::Bounds& more = steps[i].permitted;
        if (more.contains(all[i].permitted)) all[i].permitted = more;
        const bool known =
            all[i].permitted.contains(more) || std::ranges::find(all[i].others, more) != all[i].others.end();
        if (!known) all[i].others.push_back(more);
    }
}

// By how many times the error of each step, in ULP and with that of one rounding, rises above the errors of
// all steps before it. It can decrease in between.
std::vector<double> rises_of(const std::vector<ExplainedStep>& steps) {
    constexpr double one_rounding = 0.5;
    constexpr double all_lost = 0x1p24;
    std::vector<double> rises;
    double highest = 0.0;
    for (const ExplainedStep& step : steps) {
        if (!step.is_number()) {
            rises.push_back(-1.0);
            continue;
        }
        const bool overflows = std::isinf(step.value) && std::isfinite(step.exact);
        const double ulps = overflows ? all_lost : std::min(step.ulps, all_lost);
        rises.push_back(ulps > highest ? (ulps - highest) / (highest + one_rounding) : 0.0);
        highest = std::max(highest, ulps);
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

std::string permitted_text(const ExplainedStep& step) {
    std::string text = permitted_text(step.permitted);
    for (const numeric::Bounds& other : step.others) text += " or " + permitted_text(other);
    return text;
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

// Bits of an operation on integers or bools. SPIR-V's additions have no sign: what may be negative is shown
// as both.
std::string whole_text(const ExplainedStep& step) {
    const auto bits = static_cast<Word>(step.value);
    if (step.kind == ExplainedStep::Kind::truth) return bits != 0 ? "true" : "false";
    return bits >> 31U == 0 ? fmt::format("{}", bits)
                            : fmt::format("{} or {}", bits, static_cast<std::int32_t>(bits));
}

std::string line_of(const ExplainedStep& step, bool is_worst) {
    const std::string place = place_of(step) + " " + step.function;
    constexpr std::string_view names = "xyzw";
    const std::string operation = step.component == 0 ? step.operation
                                  : step.component < names.size()
                                      ? fmt::format("{} .{}", step.operation, names[step.component])
                                      : fmt::format("{} [{}]", step.operation, step.component);
    if (!step.undefined.empty())
        return fmt::format(line_format, place, operation, "undefined", "", "", "", "", step.undefined);
    if (!step.is_number()) return fmt::format("{:<34} {:<24} {:>15}\n", place, operation, whole_text(step));
    return fmt::format(line_format, place, operation, value_text(step.value, 9), value_text(step.exact, 17),
                       fmt::format("{:.3g}", step.ulps), share_text(step.local), share_text(step.inherited()),
                       permitted_text(step) + (is_worst ? "  <-- most of the error" : ""));
}

// A value that no operation of floats made; numbers without their bits.
std::string bits_text(Scalar scalar, Word word) {
    if (scalar == Scalar::float_) return value_text(double{from_word<float>(word)}, 9);
    return scalar == Scalar::uint_ ? fmt::format("{}", word) : subject::text_of(scalar, word);
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
        const std::string bits = !defined           ? "undefined"
                                 : !one.is_number() ? bits_text(all.scalars[i], static_cast<Word>(one.value))
                                                    : "";
        values.push_back(!one.is_number() || !defined ? bits : value_text(one.value, 9));
        exact.push_back(!one.is_number() || !defined ? bits : value_text(one.exact, 17));
        permitted.push_back(!one.is_number() ? bits : permitted_text(one));
        calculated = calculated || (one.is_number() && defined);
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
        const bool inherits = std::abs(worst.inherited()) > std::abs(worst.local);
        text = fmt::format("the error in ULP grows most at {}, {}: {}\n", place_of(worst), worst.operation,
                           std::isinf(worst.value) ? "it is beyond the largest number"
                           : inherits              ? "its operands bring errors, in ULP of its result"
                                                   : "its own rounding");
    }
    // The result is a variable that no operation wrote, or that of an operation.
    for (const std::vector<ExplainedStep>* all : {&steps, &explanation.result}) {
        const auto found = std::ranges::find_if(*all, [](const auto& one) { return !one.undefined.empty(); });
        if (found == all->end()) continue;
        text += fmt::format("undefined{}: {}\n", found->line == 0 ? "" : " at " + place_of(*found),
                            found->undefined);
        break;
    }
    const auto first = [&](const char* what, const auto& is_so) {
        const auto found = std::ranges::find_if(steps, is_so);
        if (found != steps.end())
            text += fmt::format("the first {} is the result of {}, {}\n", what, place_of(*found),
                                found->operation);
    };
    first("infinity", [](const auto& step) { return std::isinf(step.value); });
    first("NaN", [](const auto& step) { return std::isnan(step.value); });
    return text;
}

KernelModule lined_module(const module::CompileOptions& options, const KernelSource& source,
                          const module::SpirvCache& cache) {
    module::CompileOptions with_lines = options;
    with_lines.lines = true;
    with_lines.stage = stage_of(source.team);
    return kernel_module(source,
                         cache.compile({.name = kernel_name, .text = kernel_code(source)}, with_lines));
}

}  // namespace

KernelModule lined_module(const Lab& lab, const KernelSource& source) {
    module::CompileOptions options = lab.compile_options();
    options.variant = {};
    KernelModule module = lined_module(options, source, lab.cache());
    module.subgroup_size = std::max(lab.info().subgroup_size, 1U);
    return module;
}

Explanation explain(InterpretedKernel<Explained>& kernel, std::span<const Word> input,
                    numeric::Paths::Gaps gaps) {
    kernel.machine().set_limit(most_instructions);
    Explanation all;
    const auto run = [&] {
        std::vector<ExplainedStep> steps;
        std::vector<ExplainedStep> result;
        kernel.run(input,
                   [&](const interpreter::Step<Explained>& step) { append(step, kernel.machine(), steps); });
        for (std::size_t word = 0; word < kernel.output_words(); ++word)
            result.push_back(explained(kernel.machine(), kernel.output(word), numeric::float32));
        add_outcomes(std::move(steps), all.steps);
        add_outcomes(std::move(result), all.result);
    };
    // The path is that of float32. What is permitted apart from the first bounds comes from further runs.
    (void)numeric::Paths::explore(numeric::float32, most_outcomes, run, gaps);
    all.worst = worst_of(all.steps);
    for (ExplainedStep& one : all.result) {  // what was never written is known where the function ends
        if (one.undefined.empty() || !one.file.empty() || all.steps.empty()) continue;
        one.file = all.steps.back().file;
        one.line = all.steps.back().line;
        one.function = all.steps.back().function;
    }
    return all;
}

Explanation explain(const module::CompileOptions& options, const KernelSource& source,
                    std::span<const Word> input, const ImageSet& images) {
    const KernelModule module = lined_module(options, source, module::SpirvCache());
    if (input.size() != module.input_words)
        throw std::invalid_argument(fmt::format("{} takes {} values, got {}",
                                                module::to_glsl(source.function), module.input_words,
                                                input.size()));
    const interpreter::Program program(module.spirv);
    const std::vector<std::vector<Word>> words = image_words(module, images);
    InterpretedKernel<Explained> kernel(program, module, words);
    Explanation all = explain(kernel, input);
    all.scalars = source.signature().output_scalars();
    return all;
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

std::ostream& operator<<(std::ostream& stream, const Explanation& explanation) {
    return stream << to_text(explanation);
}

}  // namespace gloam::judge
