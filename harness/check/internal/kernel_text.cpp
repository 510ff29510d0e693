// SPDX-License-Identifier: MIT
#include "check/internal/kernel_text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace gloam::check::internal {
namespace {

using shader::Direction;
using shader::Scalar;
using shader::Type;

std::string to_word(Scalar scalar, const std::string& value) {
    switch (scalar) {
        case Scalar::float_:
            return fmt::format("floatBitsToUint({})", value);
        case Scalar::int_:
            return fmt::format("uint({})", value);
        case Scalar::bool_:
            return fmt::format("({} ? 1u : 0u)", value);
        default:
            return value;
    }
}

// The GLSL expressions of all scalars of a variable, in order: "a.x", "m[1][2]", "s.depth".
void scalar_paths(const Type& type, const std::string& variable,
                  std::vector<std::pair<Scalar, std::string>>& paths) {
    if (type.scalar == Scalar::void_) return;
    if (type.scalar == Scalar::structure) {
        for (const shader::Member& member : type.members) {
            scalar_paths(member.type, variable + "." + member.name, paths);
        }
        return;
    }
    for (int column = 0; column < type.columns; ++column) {
        const std::string base = type.columns > 1 ? fmt::format("{}[{}]", variable, column) : variable;
        for (int row = 0; row < type.rows; ++row) {
            paths.emplace_back(type.scalar, type.rows > 1 ? fmt::format("{}[{}]", base, row) : base);
        }
    }
}

// Statements that give a variable the values of the words from `offset` on; returns how many they are.
std::size_t append_read(std::string& code, const Type& type, const std::string& variable,
                        const InputText& input, std::size_t offset) {
    std::vector<std::pair<Scalar, std::string>> paths;
    scalar_paths(type, variable, paths);
    for (const auto& [scalar, path] : paths)
        code += fmt::format("    {} = {};\n", path, input(scalar, offset++));
    return paths.size();
}

std::size_t append_write(std::string& code, const Type& type, const std::string& variable,
                         std::string_view buffer, std::string_view at, std::size_t offset) {
    std::vector<std::pair<Scalar, std::string>> paths;
    scalar_paths(type, variable, paths);
    for (const auto& [scalar, path] : paths) {
        code += fmt::format("    {}[{} + {}u] = {};\n", buffer, at, offset++, to_word(scalar, path));
    }
    return paths.size();
}

std::string type_name(const Type& type) {
    return type.scalar == Scalar::structure ? type.name : shader::to_glsl(type);
}

constexpr std::string_view header = R"(#version 450
#extension GL_GOOGLE_include_directive : require
)";

// 4466 is the capability SignedZeroInfNanPreserve, 4461 its execution mode, for 32-bit floats.
constexpr std::string_view preserve = R"(#extension GL_EXT_spirv_intrinsics : require
spirv_execution_mode(extensions = ["SPV_KHR_float_controls"], capabilities = [4466], 4461, 32);
)";

constexpr std::string_view interface = R"(
layout(local_size_x = 64) in;
layout(push_constant) uniform KernelRun {
    uint kernel_count;
    uint kernel_row_length;
    uint kernel_canary;
};
layout(std430, set = 0, binding = 0) readonly buffer KernelInputs { uint kernel_inputs[]; };
layout(std430, set = 0, binding = 1) writeonly buffer KernelOutputs { uint kernel_outputs[]; };
layout(std430, set = 0, binding = 2) buffer KernelFaults { uint kernel_faults[]; };
uint kernel_input() { return gl_GlobalInvocationID.y * kernel_row_length + gl_GlobalInvocationID.x; }
void kernel_fault(uint image, ivec2 pixel) {
    if (atomicAdd(kernel_faults[0], 1u) == 0u) {
        kernel_faults[1] = image;
        kernel_faults[2] = uint(pixel.x);
        kernel_faults[3] = uint(pixel.y);
        kernel_faults[4] = kernel_input();
    }
}
)";

std::string image_interface(const ImagePrototype& image, std::size_t index) {
    return fmt::format(
        "layout(std430, set = 0, binding = {}) {}buffer KernelImage{} {{ uint kernel_image{}[]; }};\n",
        KernelBinding::first_image + index, image.stores ? "" : "readonly ", index, index);
}

// The definition of a prototype: finds the pixel, or reports the fault.
std::string image_definition(const ImagePrototype& image, std::size_t index) {
    const std::string buffer = fmt::format("kernel_image{}", index);
    const std::size_t scalars = scalars_of(image.element).size();
    const std::string type = type_name(image.element);
    std::string code = image.stores ? fmt::format("void {}(ivec2 pixel, {} value) {{\n", image.name, type)
                                    : fmt::format("{} {}(ivec2 pixel) {{\n", type, image.name);
    code += fmt::format(
        "    ivec2 size = ivec2({0}[0], {0}[1]);\n"
        "    ivec2 inside = clamp(pixel, ivec2(0), size - 1);\n"
        "    if (inside != pixel && {0}[2] == 0u) kernel_fault({1}u, pixel);\n"
        "    uint at = {2}u + uint(inside.y * size.x + inside.x) * {3}u;\n",
        buffer, index, image_header_words, scalars);
    if (image.stores) {
        code += "    if (inside != pixel) return;\n";
        append_write(code, image.element, "value", buffer, "at", 0);
    } else {
        code += fmt::format("    {} value;\n", type);
        const InputText word = [&buffer](Scalar scalar, std::size_t offset) {
            return from_word(scalar, fmt::format("{}[at + {}u]", buffer, offset));
        };
        append_read(code, image.element, "value", word, 0);
        code += "    return value;\n";
    }
    return code + "}\n";
}

}  // namespace

std::string from_word(Scalar scalar, const std::string& word) {
    switch (scalar) {
        case Scalar::float_:
            return fmt::format("uintBitsToFloat({})", word);
        case Scalar::int_:
            return fmt::format("int({})", word);
        case Scalar::bool_:
            return fmt::format("({} != 0u)", word);
        default:
            return word;
    }
}

std::string preamble(const KernelSource& source) {
    std::string code(header);
    if (source.preserve_nan) code += preserve;
    code += interface;
    for (std::size_t i = 0; i < source.images.size(); ++i) code += image_interface(source.images[i], i);
    code += fmt::format("#include \"{}\"\n", source.file);
    for (std::size_t i = 0; i < source.images.size(); ++i) code += image_definition(source.images[i], i);
    return code;
}

Evaluation evaluation(const shader::Function& function, const InputText& input) {
    Evaluation result;
    std::string arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const shader::Parameter& p = function.parameters[i];
        const std::string variable = fmt::format("argument{}", i);
        result.code += fmt::format("    {} {};\n", type_name(p.type), variable);
        if (p.direction != Direction::out)
            result.input_words += append_read(result.code, p.type, variable, input, result.input_words);
        arguments += (i > 0 ? ", " : "") + variable;
    }
    const auto write = [&](const Type& type, const std::string& variable) {
        result.output_words +=
            append_write(result.code, type, variable, "kernel_outputs", "output_at", result.output_words);
    };
    const std::string call = fmt::format("{}({});\n", function.name, arguments);
    if (function.result.scalar == Scalar::void_) {
        result.code += "    " + call;
    } else {
        result.code += fmt::format("    {} result = {}", type_name(function.result), call);
        write(function.result, "result");
    }
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        if (function.parameters[i].direction != Direction::in)
            write(function.parameters[i].type, fmt::format("argument{}", i));
    return result;
}

std::string main_begin(std::size_t output_words) {
    return fmt::format(
        "void main() {{\n"
        "    uint kernel_index = kernel_input();\n"
        "    if (gl_GlobalInvocationID.x >= kernel_row_length || kernel_index >= kernel_count) return;\n"
        "    uint output_at = kernel_index * {}u;\n",
        output_words + 1);
}

std::string main_end(std::size_t output_words) {
    return fmt::format("    kernel_outputs[output_at + {}u] = kernel_canary ^ kernel_index;\n}}\n",
                       output_words);
}

}  // namespace gloam::check::internal
