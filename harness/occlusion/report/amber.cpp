// SPDX-License-Identifier: MIT
#include "report/amber.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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

// Amber reads a number without a point as an integer, and ends a shader at the first "END".
std::string number(float value) {
    return fmt::format("{:#.9g}", value);
}

std::string without_end(std::string assembly) {
    for (std::size_t at = 0; (at = assembly.find("END", at)) != std::string::npos; at += 3) {
        assembly.replace(at, 3, "End");
    }
    return assembly;
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

// Integers are exact; a word holds negative ones in two's complement.
std::string expect_word(std::size_t byte, const numeric::Bounds& allowed) {
    const auto word = static_cast<std::uint32_t>(static_cast<std::int64_t>(allowed.low));
    return fmt::format("EXPECT words IDX {} EQ {}\n", byte, word);
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
        if (output.allowed.empty()) continue;
        const numeric::Bounds& allowed = output.allowed.front();
        text += floats ? expect_float(4 * i, allowed) : expect_word(4 * i, allowed);
    }
    return text + "\n";
}

}  // namespace

std::string to_amber(const KernelReplay& replay) {
    std::string text = "#!amber\n";
    for (const std::string& comment : replay.comments) text += "# " + comment + "\n";
    text += "\nSHADER compute kernel SPIRV-ASM TARGET_ENV spv1.5\n" + without_end(replay.assembly);
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

}  // namespace gloam::report
