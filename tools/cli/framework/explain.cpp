// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "base/number.hpp"
#include "cli/environment.hpp"
#include "cli/framework/own_file.hpp"
#include "interpreter/program.hpp"
#include "judge/explain.hpp"
#include "module/compile.hpp"

namespace gloam::cli {
namespace {

using module::Scalar;
using subject::Word;

struct ExplainOptions {
    std::vector<std::string> words;  // what to run, then values
    std::string variant = "strict";
    OwnFileOptions own;
};

// What a scalar's value is, in words.
const char* expected_of(Scalar scalar) {
    if (module::is_float(scalar)) return "a number";
    return scalar == Scalar::bool_  ? "true or false"
           : scalar == Scalar::int_ ? "a whole number"
                                    : "a whole number, 0 or more";
}

// The word of a number, true or false, or bits in hexadecimal; nothing for other text.
std::optional<Word> word_from(Scalar scalar, const std::string& text) {
    if (text.starts_with("0x")) {
        Word bits = 0;
        const char* const end = text.data() + text.size();
        const auto [at, error] = std::from_chars(text.data() + 2, end, bits, 16);
        return error == std::errc() && at == end ? std::optional(bits) : std::nullopt;
    }
    if (module::is_float(scalar)) {
        const auto number = base::number_from<double>(text);
        return number ? std::optional(subject::float_word(scalar, *number)) : std::nullopt;
    }
    if (scalar == Scalar::bool_ && (text == "true" || text == "false")) return text == "true" ? 1U : 0U;
    if (scalar != Scalar::int_) return base::number_from<Word>(text);
    const auto number = base::number_from<int>(text);
    return number ? std::optional(static_cast<Word>(*number)) : std::nullopt;
}

// The words of an input. A function of a quad or a work group takes the values of all its invocations, one
// after another for each parameter, or those of one invocation, which all have then.
std::vector<Word> input_from(const subject::OwnFunction& own, std::vector<std::string> texts) {
    struct Value {
        const module::Parameter& parameter;
        Scalar scalar;
        std::size_t in_one;  // its number among those of one invocation
    };
    std::vector<Value> values;
    std::size_t of_one = 0;
    std::size_t pixels = 0;  // of images, which come last
    for (const module::Parameter& p : own.function.parameters) {
        if (p.direction == source::Direction::out) continue;
        const bool alone = own.team.count() == 1 || !subject::is_of_each(p);
        const std::vector<Scalar> scalars = subject::scalars_of(alone ? p.type : module::element_of(p.type));
        for (std::size_t k = 0; k < (alone ? 1 : own.team.count()); ++k)
            for (std::size_t i = 0; i < scalars.size(); ++i) values.push_back({p, scalars[i], of_one + i});
        of_one += scalars.size();
        if (!p.image.empty()) pixels += scalars.size();
    }
    const std::size_t all = values.size();
    if (texts.size() + pixels == all)
        for (std::size_t k = 1; k <= pixels; ++k) texts.push_back(std::to_string(k));
    if (texts.size() != all && texts.size() != of_one)
        throw std::invalid_argument(fmt::format(
            "{} takes {} values{}{}, got {}", module::to_glsl(own.function), all,
            pixels == 0 ? "" : fmt::format(" (or {}, where pixels are 1, 2, 3 ...)", all - pixels),
            all == of_one ? "" : fmt::format(" (or {}, for all its invocations)", of_one), texts.size()));
    std::vector<Word> input;
    for (const Value& value : values) {
        const std::string& text = texts[texts.size() == of_one ? value.in_one : input.size()];
        const std::optional<Word> word = word_from(value.scalar, text);
        if (!word)
            throw std::invalid_argument(fmt::format("{} {}: expected {}, or bits as 0x..., found \"{}\"",
                                                    module::to_glsl(value.parameter.type),
                                                    value.parameter.name, expected_of(value.scalar), text));
        input.push_back(*word);
    }
    return input;
}

// The file and the function that FILE FUNCTION VALUE... names, or EQUATION VALUE..., which is all that names
// one, and the values behind it.
std::tuple<std::string, std::string, std::vector<std::string>> target_of(
    const std::vector<std::string>& words, EquationsNamed* equations) {
    std::error_code none;
    if (is_shader_file(words.front()) || std::filesystem::exists(words.front(), none)) {
        if (words.size() < 2)
            throw std::invalid_argument(words.front() + ": expected a function of this file behind it");
        return {path_of_shader(words[0]), words[1], {words.begin() + 2, words.end()}};
    }
    const std::vector<judge::Question> found = equations({words.front()});
    const judge::Question& first = found.front();
    if (words.front().find_first_of("*?") != std::string::npos && found.size() > 1)
        throw std::invalid_argument(fmt::format("{} names {} functions: expected one, for example {}",
                                                words.front(), found.size(), first.function));
    return {path_of_shader(first.file), first.function, {words.begin() + 1, words.end()}};
}

int run_explain(const ExplainOptions& options, EquationsNamed* equations) {
    const auto [file, function, values] = target_of(options.words, equations);
    const subject::OwnFunctions functions = functions_of(file, {function}, options.own).functions;
    if (functions.found.empty())
        throw std::invalid_argument(
            fmt::format("{}: {}: {}", file, functions.left_out.front().name, functions.left_out.front().why));
    const subject::OwnFunction& own = functions.found.front();
    const std::vector<Word> input = input_from(own, values);
    try {
        numeric::Random random(1);
        const auto scenarios = subject::random_scenarios(own.images);
        const subject::ImageSet images =
            scenarios.empty() ? subject::ImageSet{} : scenarios.front().make(scenarios.front().size, random);
        const judge::Explanation all =
            judge::explain({.variant = module::variant(options.variant)}, own, input, images);
        fmt::print("{}", to_text(all, all.steps.size()));
        return 0;
    } catch (const interpreter::Error& error) {
        throw std::runtime_error(fmt::format("{}: {}: {}", file, function, error.what()));
    }
}

}  // namespace

Command explain_command(EquationsNamed* equations) {
    static ExplainOptions options;
    return {
        .name = "explain",
        .about = "run a shader function on one input and show the error of each operation, line by line",
        .options = {{"file",
                     &options.words,
                     {.required = true, .numbers = true},
                     "a GLSL file and a function that it defines, or an equation (gloam list equations); "
                     "then a value for each scalar of its parameters and of the uniforms that it uses, in "
                     "order: a number, true or false, or bits as 0x...; of a quad or work group those of all "
                     "its invocations, or of one, which all have then"},
                    {"--variant", &options.variant, "how the shader is compiled (gloam list variants)"},
                    include_option(options.own.includes),
                    define_option(options.own.defines)},
        .run = [equations] { return run_explain(options, equations); },
        .examples = "  gloam explain tone.glsl my_curve 0.5 2         one value for each scalar parameter\n"};
}

}  // namespace gloam::cli
