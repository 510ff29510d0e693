// SPDX-License-Identifier: MIT
// The main() of a kernel: it calls the function, and moves its values and the pixels of its images.
#include <fmt/format.h>

#include <algorithm>

#include "check/internal/kernel_text.hpp"

namespace gloam::check::internal {

using shader::Direction;
using shader::Scalar;
using shader::Type;

std::string argument_name(std::size_t parameter) {
    return fmt::format("gloam_kernel_argument{}", parameter);
}

namespace {

// A statement that writes the canary, of which every invocation of a team adds its part.
std::string write_canary(const backend::Team& team, std::size_t output_words) {
    const std::string canary = "gloam_kernel_canary ^ gloam_kernel_index";
    if (team.kind == backend::Team::Kind::alone)
        return fmt::format("    gloam_kernel_outputs[gloam_kernel_output_at + {}u] = {};\n", output_words,
                           canary);
    return fmt::format(
        "    atomicAdd(gloam_kernel_outputs[gloam_kernel_output_row + {}u],\n"
        "              gloam_kernel_lane == 0u ? ({}) - {}u : 1u);\n",
        output_words, canary, team.count() - 1);
}

bool may_discard(const shader::Function& function) {
    return std::ranges::any_of(function.parameters,
                               [](const shader::Parameter& p) { return p.name == shader::discarded; });
}

// Nothing can be written behind a discard: until the function returns, the invocation counts as discarded.
// `discarded` is the last output.
std::string write_discarded(const KernelSource& source) {
    const Signature signature{.result = source.function.result, .parameters = source.function.parameters};
    const std::size_t output_words = signature.output_words();
    return fmt::format("    gloam_kernel_outputs[gloam_kernel_output_row + {}u + gloam_kernel_lane] = 1u;\n",
                       output_words - source.team.count()) +
           write_canary(source.team, output_words);
}

// Calls visit(image's texel, the argument's) for each pixel, both as GLSL text.
template <class Visit>
void for_each_pixel(const std::string& argument, Visit visit) {
    for (std::uint32_t y = 0; y < image_sides[1]; ++y)
        for (std::uint32_t x = 0; x < image_sides[0]; ++x)
            visit(fmt::format("ivec3({}, {}, {})", x, y, shader::image_layer),
                  fmt::format("{}[{}][{}]", argument, y, x));
}

// Statements that fill the input's layer of an image, and that read it.
std::string write_image(const shader::Parameter& image, const std::string& argument) {
    Type texel = element_of(element_of(image.type));
    const char* rest = texel.rows == 4 ? "" : texel.rows == 2 ? ", 0, 1" : ", 0, 0, 1";
    texel.rows = 4;
    std::string code = fmt::format("    {} = int(gloam_kernel_index);\n", shader::image_layer);
    for_each_pixel(argument, [&](const std::string& at, const std::string& value) {
        code +=
            fmt::format("    imageStore({}, {}, {}({}{}));\n", image.name, at, name_of(texel), value, rest);
    });
    return code;
}
std::string read_image(const shader::Parameter& image, const std::string& argument) {
    const int rows = element_of(element_of(image.type)).rows;
    const char* channels = rows == 4 ? "" : rows == 2 ? ".xy" : ".x";
    std::string code;
    for_each_pixel(argument, [&](const std::string& at, const std::string& value) {
        code += fmt::format("    {} = imageLoad({}, {}){};\n", value, image.name, at, channels);
    });
    return code;
}

}  // namespace

Evaluation evaluation(const KernelSource& source, const InputText& input) {
    const shader::Function& function = source.function;
    const bool alone = source.team.kind == backend::Team::Kind::alone;
    Evaluation result;
    std::string arguments;
    // Of what a team takes and returns, each invocation has an element.
    const auto own_type = [&](const Type& type, bool of_all) {
        return alone || of_all || type.scalar == Scalar::void_ ? type : shader::element_of(type);
    };
    // From where on the words of an invocation's element are read or written.
    const auto move_to_element = [&](const char* at, const char* row, std::size_t words, std::size_t first,
                                     bool of_all) {
        if (!alone)
            result.code += fmt::format("    {} = {} + {}u + {}u * {};\n", at, row, first, words,
                                       of_all ? "0u" : "gloam_kernel_lane");
        return alone ? first : 0;
    };
    const auto variable_of = [&function](std::size_t i) {
        const shader::Parameter& p = function.parameters[i];
        return p.global && p.image.empty() ? p.name : argument_name(i);
    };
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const shader::Parameter& p = function.parameters[i];
        const std::string variable = variable_of(i);
        if (p.type.scalar == Scalar::sampler) {
            arguments += (i > 0 ? ", " : "") + variable;
            continue;
        }
        const Type type = own_type(p.type, p.uniform);
        if (!p.global || !p.image.empty())
            result.code += fmt::format("    {} {};\n", name_of(type), variable);
        if (!p.global) {
            arguments += (i > 0 ? ", " : "") + variable;
        }
        if (p.direction == Direction::out) continue;
        const std::size_t first = move_to_element("gloam_kernel_input_at", "gloam_kernel_input_row",
                                                  scalars_of(type).size(), result.input_words, p.uniform);
        append_read(result.code, type, variable, input, first);
        result.input_words += scalars_of(p.type).size();
        if (!p.image.empty()) result.code += write_image(p, variable);
    }
    const auto write = [&](const Type& lifted, const std::string& variable) {
        const Type type = own_type(lifted, false);
        const std::size_t first = move_to_element("gloam_kernel_output_at", "gloam_kernel_output_row",
                                                  scalars_of(type).size(), result.output_words, false);
        append_write(result.code, type, variable, "gloam_kernel_outputs", "gloam_kernel_output_at", first);
        result.output_words += scalars_of(lifted).size();
    };
    const bool discards = may_discard(function);
    if (discards) result.code += write_discarded(source);
    const std::string call = fmt::format("{}({});\n", function.name, arguments);
    if (function.result.scalar == Scalar::void_) {
        result.code += "    " + call;
    } else {
        result.code +=
            fmt::format("    {} gloam_kernel_result = {}", name_of(own_type(function.result, false)), call);
        write(function.result, "gloam_kernel_result");
    }
    if (discards) result.code += fmt::format("    {} = false;\n", shader::discarded);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const shader::Parameter& p = function.parameters[i];
        if (p.direction == Direction::in) continue;
        if (!p.image.empty()) result.code += read_image(p, variable_of(i));
        write(p.type, variable_of(i));
    }
    return result;
}

std::string main_begin(const backend::Team& team, std::size_t output_words) {
    const bool alone = team.kind == backend::Team::Kind::alone;
    std::string code = fmt::format(
        "void main() {{\n"
        "    uint gloam_kernel_index = gloam_kernel_input();\n"
        "    if ({}gloam_kernel_index >= gloam_kernel_count) return;\n"
        "    uint gloam_kernel_output_at = gloam_kernel_index * {}u;\n",
        team.kind == backend::Team::Kind::group
            ? ""
            : fmt::format("{}.x >= gloam_kernel_row_length || ", input_position(team)),
        output_words + 1);
    if (alone) return code;
    return code + fmt::format(
                      "    uint gloam_kernel_output_row = gloam_kernel_output_at;\n"
                      "    uint gloam_kernel_lane = {};\n",
                      team.kind == backend::Team::Kind::group
                          ? "gl_LocalInvocationIndex"
                          : "(uint(gl_FragCoord.y) & 1u) * 2u + (uint(gl_FragCoord.x) & 1u)");
}

std::string main_end(std::size_t output_words) {
    return write_canary({}, output_words) + "}\n";
}

std::string main_of(const KernelSource& source) {
    const Evaluation calls = evaluation(source, input_of_buffer);
    const bool alone = source.team.kind == backend::Team::Kind::alone;
    return main_begin(source.team, calls.output_words) +
           fmt::format("    uint gloam_kernel_input_at = gloam_kernel_index * {}u;\n", calls.input_words) +
           (alone ? "" : "    uint gloam_kernel_input_row = gloam_kernel_input_at;\n") + calls.code +
           (may_discard(source.function) ? "}\n" : write_canary(source.team, calls.output_words) + "}\n");
}

void require_alone(const KernelSource& source, const char* what) {
    if (source.team.kind != backend::Team::Kind::alone)
        throw backend::Unsupported(fmt::format(
            "{}: runs in several invocations together, and {} runs each alone", source.function.name, what));
}

}  // namespace gloam::check::internal
