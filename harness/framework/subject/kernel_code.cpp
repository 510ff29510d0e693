// SPDX-License-Identifier: MIT
#include "subject/kernel_code.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <string_view>

#include "source/tokens.hpp"
#include "subject/internal/kernel_text.hpp"

namespace gloam::subject {

std::string kernel_code(const KernelSource& source) {
    return internal::kernel_text(source, internal::main_of(source));
}

source::Stage stage_of(const backend::Team& team) {
    return team.kind == backend::Team::Kind::quad ? source::Stage::fragment : source::Stage::compute;
}

KernelModule kernel_module(const KernelSource& source, module::Spirv spirv) {
    const Signature signature = source.signature();
    return {{.spirv = std::move(spirv),
             .input_words = signature.input_words(),
             .output_words = signature.output_words(),
             .images = {source.images.begin(), source.images.end()},
             .layer_size = image_sides,
             .name = source.function.name,
             .team = source.team},
            std::make_shared<const KernelSource>(source)};
}

}  // namespace gloam::subject

namespace gloam::subject::internal {
namespace {

using module::Scalar;

constexpr std::string_view header = R"(#version 450
#extension GL_GOOGLE_include_directive : require
)";

// 4466 is the capability SignedZeroInfNanPreserve, 4461 its execution mode, for 32-bit floats.
constexpr std::string_view preserve = R"(#extension GL_EXT_spirv_intrinsics : require
spirv_execution_mode(extensions = ["SPV_KHR_float_controls"], capabilities = [4466], 4461, 32);
)";

// Buffers without a set are in set 0 of Vulkan; OpenGL has no sets. {0}: the layout of a run's numbers, {1}:
// how the outputs are used, {2}: the position of the invocation's input.
constexpr std::string_view storage = R"({0} uniform GloamGeneratedRun {{
    uint gloam_kernel_count;
    uint gloam_kernel_row_length;
    uint gloam_kernel_canary;
}};

layout(std430, binding = 0) readonly buffer GloamGeneratedInputs {{ uint gloam_kernel_inputs[]; }};
layout(std430, binding = 1) {1}buffer GloamGeneratedOutputs {{ uint gloam_kernel_outputs[]; }};
layout(std430, binding = 2) buffer GloamGeneratedFaults {{ uint gloam_kernel_faults[]; }};
uint gloam_kernel_input() {{ return {2}.y * gloam_kernel_row_length + {2}.x; }}
void gloam_kernel_fault(uint image, ivec2 pixel) {{
    if (atomicAdd(gloam_kernel_faults[0], 1u) == 0u) {{
        gloam_kernel_faults[1] = image;
        gloam_kernel_faults[2] = uint(pixel.x);
        gloam_kernel_faults[3] = uint(pixel.y);
        gloam_kernel_faults[4] = gloam_kernel_input();
    }}
}}
)";

// The #extension lines for the kernel's own conversions.
std::string number_extensions(const KernelSource& source) {
    const auto has_half = [](const module::Type& type) {
        return std::ranges::count(scalars_of(type), Scalar::float16_) > 0;
    };
    return has_half(source.function.result) ||
                   std::ranges::any_of(source.function.parameters, has_half, &module::Parameter::type) ||
                   std::ranges::any_of(source.images, has_half, &ImagePrototype::element)
               ? "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n"
               : "";
}

// The size of the work groups; the file of a function may state the same.
std::string group_layout(const KernelSource& source) {
    const auto& team = source.team;
    if (team.kind == backend::Team::Kind::quad) return {};
    if (team.kind == backend::Team::Kind::alone)
        return fmt::format("layout(local_size_x = {}) in;\n", kernel_group_size);
    return fmt::format("layout(local_size_x = {}, local_size_y = {}, local_size_z = {}) in;\n", team.size[0],
                       team.size[1], team.size[2]);
}

std::string image_interface(const ImagePrototype& image, std::size_t index) {
    if (!image.macro.empty())
        return fmt::format("#define {} {}\n", image.macro, KernelBinding::first_image + index);
    if (image.sampled)
        return fmt::format("layout(binding = {}) uniform highp {} {};\n", KernelBinding::first_image + index,
                           image.sampler, image.variable);
    return fmt::format(
        "layout(std430, binding = {}) readonly buffer GloamGeneratedImage{} {{ uint gloam_kernel_image{}[]; "
        "}};\n",
        KernelBinding::first_image + index, index, index);
}

// The definition of a prototype: it finds the pixel or reports the fault.
std::string image_definition(const ImagePrototype& image, std::size_t index, std::string_view word_of_image) {
    const auto read_word = [&](const std::string& at) {
        return fmt::format(fmt::runtime(word_of_image), index, at);
    };
    const std::size_t scalars = scalars_of(image.element).size();
    const std::string type = name_of(image.element);
    std::string code = fmt::format(
        "{} {}(ivec2 gloam_kernel_pixel) {{\n"
        "    ivec2 gloam_kernel_size = ivec2({}, {});\n"
        "    ivec2 gloam_kernel_inside = clamp(gloam_kernel_pixel, ivec2(0), gloam_kernel_size - 1);\n"
        "    if (gloam_kernel_inside != gloam_kernel_pixel && {} == 0u)\n"
        "        gloam_kernel_fault({}u, gloam_kernel_pixel);\n"
        "    uint gloam_kernel_at = {}u + uint(gloam_kernel_inside.y * gloam_kernel_size.x +\n"
        "                                       gloam_kernel_inside.x) * {}u;\n"
        "    {} gloam_kernel_value;\n",
        type, image.name, read_word("0"), read_word("1"), read_word("2"), index, image_header_words, scalars,
        type);
    const InputText word = [&read_word](Scalar scalar, std::size_t offset) {
        return scalar_of_word(scalar, read_word(fmt::format("gloam_kernel_at + {}u", offset)));
    };
    append_read(code, image.element, "gloam_kernel_value", word, 0);
    return code + "    return gloam_kernel_value;\n}\n";
}

// Directives that undefine every name that a text uses, so that macros of the user's file do not affect the
// text.
std::string without_macros(std::string_view text) {
    std::set<std::string> words;  // that can be names of macros
    for (const source::Token& token : source::tokens_of(text))
        if (token.is_word() && !token.text.starts_with("GL_") && token.text != "defined" &&
            token.text.find("__") == std::string::npos)
            words.insert(token.text);
    std::string code;
    for (const std::string& word : words) code += fmt::format("#undef {}\n", word);
    return code;
}

}  // namespace

const char* input_position(const backend::Team& team) {
    if (team.kind == backend::Team::Kind::quad) return "(uvec2(gl_FragCoord.xy) / 2u)";
    return team.kind == backend::Team::Kind::group ? "gl_WorkGroupID" : "gl_GlobalInvocationID";
}

std::string kernel_text(const KernelSource& source, const std::string& rest) {
    std::string code(header);
    code += number_extensions(source);
    if (source.preserve_nan) code += preserve;
    return code + storage_interface(source, "\nlayout(push_constant)") +
           file_and_rest(source, word_of_buffer, rest);
}

std::string storage_interface(const KernelSource& source, std::string_view run) {
    const bool alone = source.team.kind == backend::Team::Kind::alone;
    std::string code = group_layout(source);
    code += fmt::format(storage, run, alone ? "writeonly " : "", input_position(source.team));
    for (std::size_t i = 0; i < source.images.size(); ++i) code += image_interface(source.images[i], i);
    return code;
}

std::string file_and_rest(const KernelSource& source, std::string_view word_of_image,
                          const std::string& rest) {
    std::string ours;
    for (std::size_t i = 0; i < source.images.size(); ++i)
        if (source.images[i].is_prototype()) ours += image_definition(source.images[i], i, word_of_image);
    ours += rest;
    const std::string file = source.text.empty() ? fmt::format("#include \"{}\"\n", source.file)
                                                 : source.text + "#line 1 \"kernel\"\n";
    return file + without_macros(ours) + ours;
}

}  // namespace gloam::subject::internal
