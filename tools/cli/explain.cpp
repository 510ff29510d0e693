// SPDX-License-Identifier: MIT
#include "cli/explain.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "check/explain.hpp"
#include "cli/environment.hpp"
#include "shader/variant.hpp"

namespace gloam::cli {
namespace {

using check::Word;
using shader::Scalar;

struct ExplainOptions {
    std::filesystem::path file;
    std::string function;
    std::vector<std::string> values;
    std::string variant = "strict";
};

template <class T>
T parsed(const std::string& text, int base) {
    T value{};
    const char* const first = text.data() + (base == 16 ? 2 : 0);
    const char* const last = text.data() + text.size();
    std::from_chars_result end{};
    if constexpr (std::is_floating_point_v<T>) {
        end = std::from_chars(first, last, value);
    } else {
        end = std::from_chars(first, last, value, base);
    }
    if (end.ec != std::errc() || end.ptr != last)
        throw std::invalid_argument(fmt::format("\"{}\" is no value of this parameter", text));
    return value;
}

// A number as one writes it, true or false, or the bits in hexadecimal.
Word word_from(Scalar scalar, const std::string& text) {
    constexpr int hexadecimal = 16;
    constexpr int decimal = 10;
    if (text.starts_with("0x")) return parsed<Word>(text, hexadecimal);
    switch (scalar) {
        case Scalar::float_:
            return std::bit_cast<Word>(static_cast<float>(parsed<double>(text, decimal)));
        case Scalar::int_:
            return static_cast<Word>(parsed<std::int32_t>(text, decimal));
        case Scalar::bool_:
            if (text == "true" || text == "false") return text == "true" ? 1U : 0U;
            [[fallthrough]];
        default:
            return parsed<Word>(text, decimal);
    }
}

std::string permitted_text(const numeric::Bounds& bounds) {
    if (bounds.is_anything()) return "anything";
    if (bounds.empty()) return "NaN";
    return fmt::format("[{:.9g}, {:.9g}]{}", bounds.low, bounds.high, bounds.nan ? " or NaN" : "");
}

constexpr std::string_view line_format = "{:<34} {:<24} {:>15} {:>22} {:>10} {:>11} {:>11}  {}\n";

void print(const check::Explanation& all) {
    fmt::print(line_format, "line", "operation", "float32", "double", "error ulp", "by itself", "inherited",
               "permitted");
    for (std::size_t i = 0; i < all.steps.size(); ++i) {
        const check::ExplainedStep& step = all.steps[i];
        const std::string place = fmt::format(
            "{}:{} {}", std::filesystem::path(step.file).filename().string(), step.line, step.function);
        const std::string operation = step.component == 0
                                          ? step.operation
                                          : fmt::format("{} .{}", step.operation, "xyzw"[step.component % 4]);
        fmt::print(line_format, place, operation, fmt::format("{:.9g}", step.value),
                   fmt::format("{:.17g}", step.exact), fmt::format("{:.3g}", step.ulps),
                   fmt::format("{:.2e}", step.local), fmt::format("{:.2e}", step.inherited()),
                   permitted_text(step.permitted) + (i == all.worst ? "  <-- most of the error" : ""));
    }
    if (all.worst == all.steps.size()) {
        fmt::print("no operation adds an error\n");
        return;
    }
    const check::ExplainedStep& worst = all.steps[all.worst];
    const bool cancels = std::abs(worst.inherited()) > std::abs(worst.local);
    fmt::print(
        "the error in ULP grows most at {}:{}, {}: {}\n", worst.file, worst.line, worst.operation,
        cancels ? "the result is small beside its operands, whose errors it keeps" : "its own rounding");
}

void run_explain(const ExplainOptions& options) {
    const auto folder = std::filesystem::absolute(options.file).parent_path();
    const shader::CompileOptions compile{.include_roots = {folder, glsl_directory()},
                                         .variant = shader::variant(options.variant)};
    const std::string name = options.file.filename().string();
    if (!std::filesystem::exists(options.file))
        throw std::runtime_error(fmt::format("cannot read {}", options.file.string()));
    const std::vector<Scalar> scalars = check::inputs_of(compile, name, options.function);
    if (scalars.size() != options.values.size())
        throw std::invalid_argument(fmt::format("{} takes {} values, got {}", options.function,
                                                scalars.size(), options.values.size()));
    std::vector<Word> input;
    for (std::size_t i = 0; i < scalars.size(); ++i)
        input.push_back(word_from(scalars[i], options.values[i]));
    print(check::explain(compile, name, options.function, input));
}

}  // namespace

void add_explain(CLI::App& app) {
    auto options = std::make_shared<ExplainOptions>();
    CLI::App* command = app.add_subcommand(
        "explain", "what a shader function does with one input, line by line, and where the error enters");
    command->add_option("file", options->file, "a GLSL file")->required();
    command->add_option("function", options->function, "a function that it defines")->required();
    command->add_option(
        "value", options->values,
        "one for each scalar of its parameters, in order: a number, true or false, or bits as 0x...");
    command->add_option("--variant", options->variant, "how the shader is compiled (gloam list variants)")
        ->capture_default_str();
    command->callback([options] { run_explain(*options); });
}

}  // namespace gloam::cli
