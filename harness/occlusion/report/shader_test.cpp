// SPDX-License-Identifier: MIT
#include "report/shader_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace gloam::report {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t end_mark = 0x3f800000U;
constexpr std::size_t words_of_faults = 5;
constexpr unsigned first_image = 3;

std::string storage(unsigned binding, const Words& words, std::size_t count) {
    std::string text = fmt::format("ssbo {} {}\n", binding, 4 * std::max<std::size_t>(count, 1));
    for (std::size_t i = 0; i < words.size(); ++i)
        text +=
            fmt::format("ssbo {} subdata int {} {}\n", binding, 4 * i, std::bit_cast<std::int32_t>(words[i]));
    return text;
}

std::string probe_word(std::size_t word, std::uint32_t value) {
    return fmt::format("probe ssbo uint 1 {} == 0x{:x}\n", 4 * word, value);
}

// NaN fails every comparison of a probe.
std::string probe(std::size_t word, const KernelReplay::Output& output) {
    if (output.allowed.empty()) return "";
    const numeric::Bounds& allowed = output.allowed.front();
    if (!output.is_float)
        return probe_word(word, static_cast<std::uint32_t>(static_cast<std::int64_t>(allowed.low)));
    if (allowed.nan) return "";
    const auto bound = [word](const char* comparison, double end) {
        return std::isinf(end) ? ""
                               : fmt::format("probe ssbo float 1 {} {} {:.9g}\n", 4 * word, comparison, end);
    };
    const bool anything = std::isinf(allowed.low) && std::isinf(allowed.high);
    if (anything) return fmt::format("probe ssbo float 1 {0} >= -inf\n", 4 * word);
    return bound(">=", allowed.low) + bound("<=", allowed.high);
}

std::string run_compute(const KernelReplay& kernel) {
    std::string text = "# inputs; outputs and a canary; accesses outside an image\n";
    text += storage(0, kernel.inputs, kernel.inputs.size());
    text += storage(1, {}, kernel.outputs.size() + 1);
    text += storage(2, Words(words_of_faults), words_of_faults);
    for (std::size_t i = 0; i < kernel.images.size(); ++i) {
        text +=
            fmt::format("# {}: width, height, clamped, then the pixels row by row\n", kernel.images[i].name);
        text += storage(first_image + static_cast<unsigned>(i), kernel.images[i].words,
                        kernel.images[i].words.size());
    }
    text += fmt::format(
        "uniform uint gloam_kernel_count 1\nuniform uint gloam_kernel_row_length 64\n"
        "uniform uint gloam_kernel_canary {}\ncompute 1 1 1\n",
        end_mark);
    text += "# the kernel ran to its end\n" + probe_word(kernel.outputs.size(), end_mark);
    for (std::size_t i = 0; i < kernel.outputs.size(); ++i)
        text += fmt::format("# output {}: {}\n", i, kernel.outputs[i].comment) + probe(i, kernel.outputs[i]);
    if (!kernel.images.empty()) text += "# no access fell outside an image\nprobe ssbo uint 2 0 == 0x0\n";
    return text;
}

std::string uniforms(const std::string& name, const Words& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += fmt::format("uniform uint {}[{}] {}\n", name, i, words[i]);
    return text;
}

std::string draw(const KernelReplay& kernel) {
    std::string text = uniforms("gloam_kernel_inputs", kernel.inputs);
    for (std::size_t i = 0; i < kernel.images.size(); ++i)
        text += uniforms(fmt::format("gloam_kernel_image{}", i), kernel.images[i].words);
    for (std::size_t i = 0; i < kernel.outputs.size(); ++i)
        text += fmt::format("# output {}: {}\n", i, kernel.outputs[i].comment);
    return text + "draw rect -1 -1 2 2\nprobe all rgba 0.0 1.0 0.0 1.0\n";
}

}  // namespace

std::string to_shader_test(const ShaderReplay& replay) {
    std::string text;
    for (const std::string& comment : replay.kernel.comments) text += "# " + comment + "\n";
    text += fmt::format("\n[require]\n{}\n{}\n\n", replay.version, replay.glsl_version);
    if (replay.compute) {
        text += "[compute shader]\n" + replay.glsl + "\n[test]\n" + run_compute(replay.kernel);
        return text;
    }
    const std::string version = replay.glsl.substr(0, replay.glsl.find('\n'));
    text += "[vertex shader]\n" + version +
            "\nin vec4 piglit_vertex;\nvoid main() { gl_Position = piglit_vertex; }\n\n";
    return text + "[fragment shader]\n" + replay.glsl + "\n[test]\nclear color 0.0 0.0 1.0 1.0\nclear\n" +
           draw(replay.kernel);
}

}  // namespace gloam::report
