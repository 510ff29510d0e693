// SPDX-License-Identifier: MIT
#include "report/failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace gloam::report {

namespace {

constexpr std::size_t words_in_a_line = 8;
constexpr std::size_t fault_words = 5;
// The canary that the kernel writes behind the outputs: the bits of 1, visible as a float and as a word.
constexpr std::uint32_t canary = 0x3f800000U;
constexpr auto largest = std::numeric_limits<float>::max();

std::string buffer_declaration(const std::string& name, const std::vector<std::uint32_t>& words) {
    std::string text = fmt::format("BUFFER {} DATA_TYPE uint32 DATA\n", name);
    const std::vector<std::uint32_t> one{0U};  // no buffer is empty
    const std::vector<std::uint32_t>& all = words.empty() ? one : words;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool last = i + 1 == all.size() || (i + 1) % words_in_a_line == 0;
        text += fmt::format("0x{:08x}{}", all[i], last ? "\n" : " ");
    }
    return text + "END\n\n";
}

// Amber reads a number without a point as an integer.
std::string number(float value) {
    return fmt::format("{:#.9g}", value);
}

// The ends of a range as floats inside it.
float lowest_inside(double low) {
    auto value = static_cast<float>(low);
    return static_cast<double>(value) < low ? std::nextafter(value, INFINITY) : value;
}
float highest_inside(double high) {
    auto value = static_cast<float>(high);
    return static_cast<double>(value) > high ? std::nextafter(value, -INFINITY) : value;
}

// Amber's comparisons are true for NaN, so NaN is excluded separately. Amber has no word for infinity.
std::string expect_float(std::size_t byte, const numeric::Bounds& allowed) {
    const auto expect = [byte](const std::string& condition) {
        return fmt::format("EXPECT floats IDX {} {}\n", byte, condition);
    };
    if (allowed.low > allowed.high) return allowed.nan ? expect("EQ nan") : std::string{};
    std::string text;
    if (!allowed.nan) text += expect("NE nan");
    const float low = lowest_inside(allowed.low);
    const float high = highest_inside(allowed.high);
    if (low > largest) {
        text += expect("GT " + number(largest));
    } else if (low >= -largest) {
        text += expect("GE " + number(low));
    }
    if (high < -largest) {
        text += expect("LT " + number(-largest));
    } else if (high <= largest) {
        text += expect("LE " + number(high));
    }
    return text;
}

// The hull of an output's ranges, as it is expected where a script cannot say "or".
numeric::Bounds hull_at(const KernelReplay& replay, std::size_t output) {
    numeric::Bounds all = replay.outcomes.front().at(output);
    for (const check::Sample::Outcome& outcome : replay.outcomes)
        all = numeric::hull(all, outcome.at(output));
    return all;
}

bool is_inside(const KernelReplay::Output& output, const numeric::Bounds& bounds) {
    if (output.is_float) return bounds.contains(static_cast<double>(std::bit_cast<float>(output.found)));
    const std::int64_t number =
        bounds.low < 0.0 ? std::bit_cast<std::int32_t>(output.found) : std::int64_t{output.found};
    return bounds.contains(static_cast<double>(number));
}

// Whether what was found is inside the hull, but in no outcome's range.
bool is_between(const KernelReplay& replay, std::size_t i) {
    const KernelReplay::Output& output = replay.outputs[i];
    return is_inside(output, hull_at(replay, i)) &&
           std::ranges::none_of(replay.outcomes,
                                [&](const auto& outcome) { return is_inside(output, outcome.at(i)); });
}

// The comparisons of a word with a range of integers, as unsigned: in two's complement a range from below 0
// to above it has none.
std::vector<std::pair<const char*, std::uint32_t>> word_comparisons(const numeric::Bounds& allowed) {
    const auto word = [](double x) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(x, -0x1p31, 0x1p32 - 1.0)));
    };
    if (allowed.is_point()) return {{"==", word(allowed.low)}};
    if (allowed.low < 0.0 && allowed.high >= 0.0) return {};
    return {{">=", word(allowed.low)}, {"<=", word(allowed.high)}};
}

// The same for Amber.
std::string expect_word(std::size_t byte, const numeric::Bounds& allowed) {
    std::string text;
    for (const auto& [comparison, word] : word_comparisons(allowed))
        text += fmt::format("EXPECT words IDX {} {} {}\n", byte,
                            *comparison == '='   ? "EQ"
                            : *comparison == '>' ? "GE"
                                                 : "LE",
                            word);
    return text;
}

// A comment behind the one of an output.
std::string several_outcomes(const KernelReplay& replay) {
    if (replay.outcomes.size() < 2) return "";
    return fmt::format("# one of {} outcomes is allowed (report.txt); this expects their hull\n",
                       replay.outcomes.size());
}

std::string pipeline(const KernelReplay& replay, const std::string& view) {
    std::string constants;
    for (std::size_t i = 0; replay.specialized && i < replay.inputs.size(); ++i) {
        constants += fmt::format(" SPECIALIZE {} AS uint32 {}", i, replay.inputs[i]);
    }
    std::string text = fmt::format(
        "PIPELINE compute read_{0}\n"
        "  ATTACH kernel{1}\n"
        "  BIND BUFFER run AS push_constant\n"
        "  BIND BUFFER inputs AS storage DESCRIPTOR_SET 0 BINDING 0\n"
        "  BIND BUFFER {0} AS storage DESCRIPTOR_SET 0 BINDING 1\n"
        "  BIND BUFFER faults AS storage DESCRIPTOR_SET 0 BINDING 2\n",
        view, constants);
    for (std::size_t i = 0; i < replay.images.size(); ++i) {
        text += fmt::format("  BIND BUFFER image{} AS storage DESCRIPTOR_SET 0 BINDING {}\n", i, 3 + i);
    }
    return text + fmt::format("END\n\nRUN read_{} 1 1 1\n", view);
}

// A view of the outputs as floats or as words, because an Amber buffer has one type.
std::string view_of(const KernelReplay& replay, bool floats) {
    const std::string view = floats ? "floats" : "words";
    std::string text =
        fmt::format("BUFFER {} DATA_TYPE {} SIZE {} FILL {}\n\n", view, floats ? "float" : "uint32",
                    replay.outputs.size() + 1, floats ? "0.0" : "0");
    text += pipeline(replay, view);
    text += "# the kernel ran to its end\n";
    text += fmt::format("EXPECT {} IDX {} EQ {}\n", view, 4 * replay.outputs.size(),
                        floats ? "1.0" : std::to_string(canary));
    for (std::size_t i = 0; i < replay.outputs.size(); ++i) {
        const KernelReplay::Output& output = replay.outputs[i];
        if (output.is_float != floats) continue;
        text += fmt::format("# output {}: {}\n", i, output.comment);
        if (replay.outcomes.empty()) continue;
        const numeric::Bounds allowed = hull_at(replay, i);
        text += several_outcomes(replay);
        text += floats ? expect_float(4 * i, allowed) : expect_word(4 * i, allowed);
        if (is_between(replay, i))
            text += fmt::format(
                "EXPECT {} IDX {} NE {}\n", view, 4 * i,
                floats ? number(std::bit_cast<float>(output.found)) : std::to_string(output.found));
    }
    return text + "\n";
}

}  // namespace

std::string to_amber(const KernelReplay& replay) {
    std::string text = "#!amber\n";
    for (const std::string& comment : replay.comments) text += "# " + comment + "\n";
    // Amber ends a shader at the first "END".
    text += "\nSHADER compute kernel SPIRV-ASM TARGET_ENV spv1.5\n" +
            base::replaced(replay.assembly, "END", "End");
    if (!text.ends_with('\n')) text += '\n';
    text += "END\n\n";
    text += "# how many inputs, invocations in a row, the word to write behind the outputs\n";
    text += buffer_declaration("run", {1U, 64U, canary});
    text += buffer_declaration("inputs", replay.inputs);
    text += "# accesses outside an image: how many, and the first\n";
    text += buffer_declaration("faults", std::vector<std::uint32_t>(fault_words));
    for (std::size_t i = 0; i < replay.images.size(); ++i) {
        text +=
            fmt::format("# {}: width, height, clamped, then the pixels row by row\n", replay.images[i].name);
        text += buffer_declaration(fmt::format("image{}", i), replay.images[i].words);
    }
    const auto is_float = [](const KernelReplay::Output& output) { return output.is_float; };
    if (std::ranges::any_of(replay.outputs, is_float)) text += view_of(replay, true);
    if (!std::ranges::all_of(replay.outputs, is_float)) text += view_of(replay, false);
    if (!replay.images.empty()) text += "# no access fell outside an image\nEXPECT faults IDX 0 EQ 0\n";
    return text;
}

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

std::string probe_word(std::size_t word, const char* comparison, std::uint32_t value) {
    return fmt::format("probe ssbo uint 1 {} {} 0x{:x}\n", 4 * word, comparison, value);
}

// NaN fails every comparison of a probe.
std::string probe_float(std::size_t word, const numeric::Bounds& allowed) {
    if (allowed.nan) return "";
    const auto bound = [word](const char* comparison, double end) {
        return std::isinf(end) ? ""
                               : fmt::format("probe ssbo float 1 {} {} {:.9g}\n", 4 * word, comparison, end);
    };
    const bool anything = std::isinf(allowed.low) && std::isinf(allowed.high);
    if (anything) return fmt::format("probe ssbo float 1 {0} >= -inf\n", 4 * word);
    return bound(">=", allowed.low) + bound("<=", allowed.high);
}

std::string probe(const KernelReplay& kernel, std::size_t word) {
    if (kernel.outcomes.empty()) return "";
    const KernelReplay::Output& output = kernel.outputs[word];
    const numeric::Bounds allowed = hull_at(kernel, word);
    std::string text = several_outcomes(kernel);
    if (output.is_float)
        text += probe_float(word, allowed);
    else
        for (const auto& [comparison, value] : word_comparisons(allowed))
            text += probe_word(word, comparison, value);
    return is_between(kernel, word) ? text + probe_word(word, "!=", output.found) : text;
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
    text += "# the kernel ran to its end\n" + probe_word(kernel.outputs.size(), "==", end_mark);
    for (std::size_t i = 0; i < kernel.outputs.size(); ++i)
        text += fmt::format("# output {}: {}\n", i, kernel.outputs[i].comment) + probe(kernel, i);
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
