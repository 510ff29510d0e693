// SPDX-License-Identifier: MIT
#include "check/own_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include "shader/include.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

constexpr double usual_low = 1e-6;
constexpr double usual_high = 1e6;
constexpr long usual_integer = 1000;
constexpr long largest_unsigned = 1L << 31;

Values scalar_values(Scalar scalar, const std::optional<Range>& range) {
    switch (scalar) {
        case Scalar::float_:
            return range ? uniform(range->low, range->high)
                         : signed_log_uniform(usual_low, usual_high).and_special();
        case Scalar::int_:
            return range ? integers(static_cast<long>(range->low), static_cast<long>(range->high))
                         : integers(-usual_integer, usual_integer);
        case Scalar::uint_:
            return range ? integers(static_cast<long>(range->low), static_cast<long>(range->high))
                         : log_integers(largest_unsigned);
        default:
            return booleans();
    }
}

Values values_of(const shader::Type& type, const std::optional<Range>& range) {
    std::vector<Values> scalars;
    for (const Scalar scalar : scalars_of(type)) scalars.push_back(scalar_values(scalar, range));
    return scalars.size() == 1 ? scalars.front() : vector(scalars);
}

double number_from(std::string_view text, const std::string& whole) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument(fmt::format("--range {}: expected NAME=LOW:HIGH", whole));
    return value;
}

bool is_usable(const shader::Function& function) {
    return function.defined && function.name != "main" &&
           (function.result.scalar == Scalar::void_ || shader::is_supported(function.result)) &&
           std::ranges::all_of(function.parameters,
                               [](const shader::Parameter& p) { return shader::is_supported(p.type); });
}

// Whether a text contains "TYPE NAME (" with the function's type and name; a definition does, a call does
// not.
bool declares(std::string_view text, const shader::Function& function) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    const std::string type =
        function.result.scalar == Scalar::structure ? function.result.name : shader::to_glsl(function.result);
    for (std::size_t at = text.find(function.name); at != std::string_view::npos;
         at = text.find(function.name, at + 1)) {
        std::size_t behind = at + function.name.size();
        while (behind < text.size() && is_blank(text[behind])) ++behind;
        std::size_t end = at;
        while (end > 0 && is_blank(text[end - 1])) --end;
        std::size_t begin = end;
        while (begin > 0 && is_word(text[begin - 1])) --begin;
        if (end < at && behind < text.size() && text[behind] == '(' &&
            text.substr(begin, end - begin) == type)
            return true;
    }
    return false;
}

// Images for prototypes: positive numbers of usual size. Accesses outside read the border.
ImageScenario random_images(const std::vector<ImagePrototype>& prototypes) {
    const auto make = [prototypes](glm::ivec2 size, numeric::Random& random) {
        ImageSet images;
        for (const ImagePrototype& prototype : prototypes) {
            Image image{.element = prototype.element, .size = size, .border = Border::clamp, .words = {}};
            for (int pixel = 0; pixel < size.x * size.y; ++pixel) {
                for (const Scalar scalar : scalars_of(prototype.element)) {
                    const auto value = static_cast<float>(random.uniform(0.1, 10.0));
                    image.words.push_back(scalar == Scalar::float_ ? to_word(value)
                                                                   : static_cast<Word>(random.below(2)));
                }
            }
            images.emplace(prototype.name, std::move(image));
        }
        return images;
    };
    return {.name = "5 x 4, random", .size = {5, 4}, .make = make};
}

}  // namespace

std::pair<std::string, Range> range_from(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::size_t colon = text.find(':', std::min(equals, text.size()));
    if (equals == 0 || equals == std::string::npos || colon == std::string::npos)
        throw std::invalid_argument(fmt::format("--range {}: expected NAME=LOW:HIGH", text));
    const std::string_view view(text);
    const Range range{number_from(view.substr(equals + 1, colon - equals - 1), text),
                      number_from(view.substr(colon + 1), text)};
    if (!(range.low <= range.high))
        throw std::invalid_argument(fmt::format("--range {}: expected LOW <= HIGH", text));
    return {text.substr(0, equals), range};
}

std::vector<shader::Function> own_functions(const shader::CompileOptions& options, const std::string& file) {
    const auto path = shader::resolve_include(file, {}, options.include_roots);
    const std::string text = shader::read_text(path);
    const shader::Source probe{.name = "signature of " + file,
                               .text = fmt::format("#version 450\n#include \"{}\"\n", file)};
    std::vector<shader::Function> own;
    for (const shader::Function& function : shader::functions(probe, options))
        if (is_usable(function) && declares(text, function)) own.push_back(function);
    return own;
}

Question question_of(const Lab& lab, const std::string& file, const shader::Function& function,
                     const Ranges& ranges) {
    Question question{.file = file,
                      .function = function.name,
                      .signature = {.result = function.result, .parameters = function.parameters}};
    std::set<std::string> known;
    std::vector<Values> parameters;
    for (const shader::Parameter& parameter : function.parameters) {
        known.insert(parameter.name);
        if (parameter.direction == shader::Direction::out) continue;
        const auto found = ranges.find(parameter.name);
        parameters.push_back(
            values_of(parameter.type, found == ranges.end() ? std::nullopt : std::optional(found->second)));
    }
    question.domain = Domain(std::move(parameters));
    const KernelSource source = lab.source(file, function.name, question.signature);
    if (!source.images.empty()) question.scenarios = {random_images(source.images)};
    return question;
}

}  // namespace gloam::check
