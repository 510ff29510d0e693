// SPDX-License-Identifier: MIT
#include "site/page_data.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "module/texts.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;

std::string words_text(std::span<const check::Word> words) {
    Bytes bytes;
    for (const check::Word word : words) bytes.add(word);
    return bytes.text();
}

// Without comments; names are freed of macros only where there are some.
std::string kernel_text(const std::string& kernel) {
    const std::string code = shader::code_of(kernel);
    return code.find("#define") == std::string::npos ? std::regex_replace(code, std::regex("#undef .*\n"), "")
                                                     : code;
}

// null where there is no end.
ordered_json end_json(double end) {
    return std::isfinite(end) ? ordered_json(end) : ordered_json(nullptr);
}

// One letter for each word: f, i, u or b.
std::string letters(const std::vector<shader::Scalar>& scalars) {
    std::string text;
    for (const shader::Scalar scalar : scalars) {
        text += scalar == shader::Scalar::float_  ? 'f'
                : scalar == shader::Scalar::int_  ? 'i'
                : scalar == shader::Scalar::bool_ ? 'b'
                                                  : 'u';
    }
    return text;
}

ordered_json parameters_json(const check::Signature& signature) {
    ordered_json json = ordered_json::array();
    for (const shader::Parameter& parameter : signature.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        json.push_back({to_glsl(parameter.type), check::scalars_of(parameter.type).size()});
    }
    return json;
}

ordered_json budget_json(const check::Budget& budget) {
    return {{"ulp", budget.ulp},
            {"abs", budget.absolute},
            {"backward_ulp", budget.backward_ulp},
            {"of_largest_component", budget.of_largest_component},
            {"text", to_text(budget)}};
}

ordered_json scenario_json(const check::PreparedScenario& scenario) {
    Bytes classes;
    Bytes criteria;
    Bytes counts;
    Bytes wants;
    for (const check::Expectation& expectation : scenario.expectations) {
        // Of a recorded input: which of a predicate's two results is not judged.
        const bool judged = expectation.criterion != check::Criterion::recorded;
        const std::size_t count = judged ? expectation.wants.size() : 1;
        classes.add(static_cast<std::uint8_t>(expectation.input_class));
        criteria.add(static_cast<std::uint8_t>(expectation.criterion));
        counts.add(static_cast<std::uint16_t>(count));
        for (std::size_t i = 0; i < count; ++i)
            for (const double want : expectation.wants[i]) wants.add(want);
    }
    ordered_json images = ordered_json::array();
    for (const std::vector<check::Word>& image : scenario.image_words) images.push_back(words_text(image));
    return {{"name", scenario.name},       {"count", scenario.inputs.count()},
            {"images", std::move(images)}, {"inputs", words_text(scenario.inputs.words)},
            {"classes", classes.text()},   {"criteria", criteria.text()},
            {"counts", counts.text()},     {"wants", wants.text()}};
}

}  // namespace

std::string check_json(const catalogue::Description& description, const check::Question& question,
                       const check::PreparedCheck& prepared) {
    ordered_json scenarios = ordered_json::array();
    for (const check::PreparedScenario& scenario : prepared.scenarios)
        scenarios.push_back(scenario_json(scenario));
    const ordered_json json{{"equation", description.id},
                            {"function", question.function},
                            {"file", question.file},
                            {"title", description.title},
                            {"budget", budget_json(question.budget)},
                            {"codomain", {end_json(question.codomain.low), end_json(question.codomain.high)}},
                            {"parameters", parameters_json(question.signature)},
                            {"inputs", letters(question.signature.input_scalars())},
                            {"outputs", letters(question.signature.output_scalars())},
                            {"values", question.signature.output_values()},
                            {"row", prepared.row_words},
                            {"targets", prepared.targets},
                            {"unsupported", prepared.unsupported},
                            {"kernel", kernel_text(prepared.kernel)},
                            {"scenarios", std::move(scenarios)}};
    return json.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

}  // namespace gloam::site
