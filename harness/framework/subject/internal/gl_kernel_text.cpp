// SPDX-License-Identifier: MIT
#include "subject/internal/kernel_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "backend/gl/kernel.hpp"
#include "backend/gl/resources.hpp"
#include "base/text.hpp"
#include "module/spirv.hpp"
#include "module/texts.hpp"

namespace gloam::subject::internal {
namespace {

using module::Scalar;

std::string fragment_interface(const KernelSource& source, std::size_t row, std::size_t targets) {
    std::string code =
        "uniform uint gloam_kernel_count;\nuniform uint gloam_kernel_canary;\n"
        "uniform uint gloam_kernel_pass;\nuniform highp usampler2D gloam_kernel_inputs;\n";
    for (std::size_t i = 0; i < source.images.size(); ++i)
        code += fmt::format("uniform highp usampler2D gloam_kernel_image{};\n", i);
    for (std::size_t i = 0; i < targets; ++i)
        code += fmt::format("layout(location = {}) out highp uvec4 gloam_kernel_target{};\n", i, i);
    code += fmt::format("uint gloam_kernel_outputs[{}];\nuint gloam_kernel_faults[{}];\n", row,
                        backend::gl::kernel_fault_words);
    code += fmt::format(
        "uint gloam_kernel_word(highp usampler2D words, uint at) {{\n"
        "    return texelFetch(words, ivec2(int(at % {0}u), int(at / {0}u)), 0).x;\n}}\n",
        backend::gl::WordTexture::row);
    return code + R"(void gloam_kernel_fault(uint image, ivec2 pixel) {
    if (gloam_kernel_faults[0] == 0u) {
        gloam_kernel_faults[1] = image;
        gloam_kernel_faults[2] = uint(pixel.x);
        gloam_kernel_faults[3] = uint(pixel.y);
    }
    gloam_kernel_faults[0] += 1u;
}
)";
}

// Statements that write the words of one pass to the targets.
std::string write_pass(std::size_t first, std::size_t row, std::size_t targets) {
    std::string code;
    for (std::size_t target = 0; target < targets; ++target) {
        std::string words;
        for (std::size_t k = 0; k < backend::gl::kernel_target_words; ++k) {
            const std::size_t at = first + target * backend::gl::kernel_target_words + k;
            words += (k > 0 ? ", " : "") + (at < row ? fmt::format("gloam_kernel_outputs[{}]", at) : "0u");
        }
        code += fmt::format("        gloam_kernel_target{} = uvec4({});\n", target, words);
    }
    return code;
}

std::string fragment_end(std::size_t output_words, std::size_t images, std::size_t targets) {
    std::string code = fmt::format(
        "    gloam_kernel_outputs[{}] = gloam_kernel_canary ^ gloam_kernel_index;\n", output_words);
    for (std::size_t k = 0; images > 0 && k < backend::gl::kernel_fault_words; ++k)
        code +=
            fmt::format("    gloam_kernel_outputs[{}] = gloam_kernel_faults[{}];\n", output_words + 1 + k, k);
    const std::size_t row = backend::gl::kernel_row(output_words, images);
    const std::size_t words = targets * backend::gl::kernel_target_words;
    for (std::size_t pass = 0; pass * words < row; ++pass) {
        code += fmt::format("    if (gloam_kernel_pass == {}u) {{\n{}    }}\n", pass,
                            write_pass(pass * words, row, targets));
    }
    return code + "}\n";
}

void require_bindable(source::Language language, const KernelSource& source) {
    for (const ImagePrototype& image : source.images) {
        if (!image.layered.empty())
            throw backend::Unsupported(fmt::format("{}: uses the image {}, which needs a Vulkan device",
                                                   source.function.name, image.name));
        if (image.sampled && source::usual_stage(language) != source::Stage::compute)
            throw backend::Unsupported(fmt::format(
                "{}: reads the sampler {}, which needs a Vulkan device, OpenGL 4.3 or OpenGL ES 3.1",
                source.function.name, image.name));
    }
}

std::string gl_compute_text(const KernelSource& source) {
    return storage_interface(source,
                             fmt::format("layout(std140, binding = {})", backend::gl::kernel_run_binding)) +
           file_and_rest(source, word_of_buffer, main_of(source));
}

std::string gl_fragment_text(const KernelSource& source) {
    const auto input = [](Scalar scalar, std::size_t word) {
        return scalar_of_word(
            scalar,
            fmt::format("gloam_kernel_word(gloam_kernel_inputs, uint(gloam_kernel_input_at + {}u))", word));
    };
    const Evaluation calls = evaluation(source, input);
    const std::size_t row = backend::gl::kernel_row(calls.output_words, source.images.size());
    const std::size_t targets = backend::gl::kernel_targets(row);
    const std::string begin = fmt::format(
        "void main() {{\n"
        "    uint gloam_kernel_index =\n"
        "        min(uint(gl_FragCoord.y) * {}u + uint(gl_FragCoord.x), gloam_kernel_count - 1u);\n"
        "    uint gloam_kernel_output_at = 0u;\n"
        "    gloam_kernel_faults[0] = 0u;\n"
        "    uint gloam_kernel_input_at = gloam_kernel_index * {}u;\n",
        backend::gl::kernel_target_width, calls.input_words);
    return fragment_interface(source, row, targets) +
           file_and_rest(
               source, "gloam_kernel_word(gloam_kernel_image{}, uint({}))",
               begin + calls.code + fragment_end(calls.output_words, source.images.size(), targets));
}

// Of SPIR-V: OpExtInst, and the numbers of its set GLSL.std.450 from Sin to Atan2, and of two for matrices.
constexpr std::uint32_t extended = 12;
constexpr std::uint32_t sine = 13;
constexpr std::uint32_t arc_tangent_of_two = 25;
constexpr std::uint32_t determinant = 33;
constexpr std::uint32_t inverse = 34;

}  // namespace

bool has_precision_rules(source::Language language, const module::Spirv& module) {
    if (language != source::Language::vulkan450 && language != source::Language::es320) return false;
    return std::ranges::none_of(module::instructions(module), [](const module::Instruction& instruction) {
        if (instruction.opcode != extended) return false;
        const std::uint32_t function = instruction.word(4);
        return (function >= sine && function <= arc_tangent_of_two) || function == determinant ||
               function == inverse;
    });
}

}  // namespace gloam::subject::internal

namespace gloam::subject {

std::string gl_kernel_code(source::Language language, const KernelSource& source,
                           const std::vector<std::filesystem::path>& include_roots) {
    internal::require_alone(source, "OpenGL");
    internal::require_bindable(language, source);
    const bool compute = source::usual_stage(language) == source::Stage::compute;
    const source::Source text{
        .name = "kernel of " + source.function.name,
        .text = compute ? internal::gl_compute_text(source) : internal::gl_fragment_text(source)};
    try {
        return module::pack({text}, {.language = language}, include_roots);
    } catch (const source::CompileError& error) {  // it has been compiled as GLSL 450
        throw backend::Unsupported(fmt::format("{} is no GLSL {}: {}", source.function.name,
                                               to_string(language), base::one_line(error.what())));
    }
}

}  // namespace gloam::subject
