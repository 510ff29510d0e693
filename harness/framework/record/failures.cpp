// SPDX-License-Identifier: MIT
#include "record/failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "base/text.hpp"

namespace gloam::record {

namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::size_t words_in_a_line = 8;
constexpr std::size_t fault_words = 5;
// The canary that the kernel writes behind the outputs: the bits of 1, visible as a float and as a word.
constexpr std::uint32_t canary = 0x3f800000U;
constexpr auto largest = std::numeric_limits<float>::max();

std::string buffer_declaration(const std::string& name, const Words& words) {
    std::string text = fmt::format("BUFFER {} DATA_TYPE uint32 DATA\n", name);
    const Words& all = words.empty() ? Words{0U} : words;  // no buffer is empty
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool last = i + 1 == all.size() || (i + 1) % words_in_a_line == 0;
        text += fmt::format("0x{:08x}{}", all[i], last ? "\n" : " ");
    }
    return text + "END\n\n";
}

std::string image_comment(const KernelReplay::Image& image) {
    return fmt::format("# {}: width, height, clamped, then the pixels row by row\n", image.name);
}

// The hull of an output's ranges, as a script cannot say "or".
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

// Of an output, as the float or the word that it is, with a number: "GE 1.00000000".
using Comparisons = std::vector<std::string>;

// Amber reads a number without a point as an integer, and has no word for infinity. Its comparisons are true
// for NaN, so NaN is excluded by one of them. Ends of a range are floats inside it.
void compare_float(const numeric::Bounds& allowed, Comparisons& all) {
    const auto add = [&](const char* sign, float x) { all.push_back(fmt::format("{} {:#.9g}", sign, x)); };
    if (allowed.low > allowed.high) {
        if (allowed.nan) all.push_back("EQ nan");
        return;
    }
    if (!allowed.nan) all.push_back("NE nan");
    auto low = static_cast<float>(allowed.low);
    auto high = static_cast<float>(allowed.high);
    if (static_cast<double>(low) < allowed.low) low = std::nextafter(low, INFINITY);
    if (static_cast<double>(high) > allowed.high) high = std::nextafter(high, -INFINITY);
    if (low >= -largest) add(low > largest ? "GT" : "GE", std::min(low, largest));
    if (high <= largest) add(high < -largest ? "LT" : "LE", std::max(high, -largest));
}

// As unsigned: in two's complement a range from below 0 to above it has no comparison.
void compare_word(const numeric::Bounds& allowed, Comparisons& all) {
    const auto add = [&](const char* sign, double x) {
        const auto number = static_cast<std::int64_t>(std::clamp(x, -0x1p31, 0x1p32 - 1.0));
        all.push_back(fmt::format("{} {}", sign, static_cast<std::uint32_t>(number)));
    };
    if (allowed.is_point()) return add("EQ", allowed.low);
    if (allowed.low < 0.0 && allowed.high >= 0.0) return;
    add("GE", allowed.low);
    add("LE", allowed.high);
}

// Those with the hull, and with what was found where that is in the hull, but in no outcome's range.
Comparisons comparisons_of(const KernelReplay& replay, std::size_t i) {
    if (replay.outcomes.empty()) return {};
    const KernelReplay::Output& output = replay.outputs[i];
    const numeric::Bounds hull = hull_at(replay, i);
    Comparisons all;
    (output.is_float ? compare_float : compare_word)(hull, all);
    const bool between =
        is_inside(output, hull) && std::ranges::none_of(replay.outcomes, [&](const auto& outcome) {
            return is_inside(output, outcome.at(i));
        });
    if (between)
        all.push_back(output.is_float ? fmt::format("NE {:#.9g}", std::bit_cast<float>(output.found))
                                      : fmt::format("NE {}", output.found));
    return all;
}

// The comments above the comparisons of an output.
std::string output_comments(const KernelReplay& replay, std::size_t i) {
    std::string text = fmt::format("# output {}: {}\n", i, replay.outputs[i].comment);
    if (replay.outcomes.size() > 1)
        text += fmt::format("# one of {} outcomes is allowed (report.txt); this expects their hull\n",
                            replay.outcomes.size());
    return text;
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
        if (replay.outputs[i].is_float != floats) continue;
        text += output_comments(replay, i);
        for (const std::string& comparison : comparisons_of(replay, i))
            text += fmt::format("EXPECT {} IDX {} {}\n", view, 4 * i, comparison);
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
    text += buffer_declaration("faults", Words(fault_words));
    for (std::size_t i = 0; i < replay.images.size(); ++i) {
        text += image_comment(replay.images[i]);
        text += buffer_declaration(fmt::format("image{}", i), replay.images[i].words);
    }
    const auto is_float = [](const KernelReplay::Output& output) { return output.is_float; };
    if (std::ranges::any_of(replay.outputs, is_float)) text += view_of(replay, true);
    if (!std::ranges::all_of(replay.outputs, is_float)) text += view_of(replay, false);
    if (!replay.images.empty()) text += "# no access fell outside an image\nEXPECT faults IDX 0 EQ 0\n";
    return text;
}

}  // namespace gloam::record
