// SPDX-License-Identifier: MIT
#include "record/failures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "judge/interpretation.hpp"
#include "numeric/numbers.hpp"
#include "record/assets.hpp"

namespace gloam::record {

namespace {

using judge::Reproduction;
using Words = std::vector<std::uint32_t>;

constexpr std::size_t words_in_a_line = 8;
// Of a kernel of one input. Its canary is 1 as a float, which is visible as a float and as a word.
constexpr subject::KernelRun one_input{
    .count = 1, .row_length = subject::kernel_group_size, .canary = 0x3f800000U};
constexpr auto largest = std::numeric_limits<float>::max();

// No buffer and no array is empty.
Words not_empty(Words words) {
    if (words.empty()) words.push_back(0U);
    return words;
}

std::string buffer_declaration(const std::string& name, const Words& words) {
    std::string text = fmt::format("BUFFER {} DATA_TYPE uint32 DATA\n", name);
    const Words all = not_empty(words);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool last = i + 1 == all.size() || (i + 1) % words_in_a_line == 0;
        text += fmt::format("0x{:08x}{}", all[i], last ? "\n" : " ");
    }
    return text + "END\n\n";
}

bool is_float(const Reproduction& all, std::size_t output) {
    return all.outputs[output] == module::Scalar::float_;  // others are compared as words
}

std::string output_comment(const Reproduction& all, std::size_t output) {
    if (!all.failure) return "not judged";
    const std::uint32_t word = all.failure->got[output];
    const std::string got =
        is_float(all, output) ? subject::text_of(all.outputs[output], word) : fmt::format("0x{:08x}", word);
    return fmt::format("here it was {}; the reference gives {}", got,
                       numeric::to_text(all.failure->want[output]));
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

// Those with the hull, as a script cannot say "or", and with what was found where no outcome has that.
Comparisons comparisons_of(const Reproduction& all, std::size_t i) {
    if (all.outcomes.empty()) return {};
    const bool as_float = is_float(all, i);
    const std::uint32_t found = all.failure->got[i];
    const double number = subject::number_at(all.outputs[i], found);
    const numeric::Bounds hull = judge::hull_of(all.outcomes)[i];
    Comparisons comparisons;
    (as_float ? compare_float : compare_word)(hull, comparisons);
    if (hull.contains(number) &&
        std::ranges::none_of(all.outcomes, [&](const judge::Sample::Outcome& outcome) {
            return outcome.at(i).contains(number);
        }))
        comparisons.push_back(as_float ? fmt::format("NE {:#.9g}", number) : fmt::format("NE {}", found));
    return comparisons;
}

std::string pipeline(const Reproduction& all, const std::string& view) {
    std::string constants;
    for (std::size_t i = 0; all.specialized && i < all.inputs.size(); ++i)
        constants += fmt::format(" SPECIALIZE {} AS uint32 {}", i, all.inputs[i]);
    std::string text = fmt::format(
        "PIPELINE compute read_{0}\n"
        "  ATTACH kernel{1}\n"
        "  BIND BUFFER run AS push_constant\n"
        "  BIND BUFFER inputs AS storage DESCRIPTOR_SET 0 BINDING 0\n"
        "  BIND BUFFER {0} AS storage DESCRIPTOR_SET 0 BINDING 1\n"
        "  BIND BUFFER faults AS storage DESCRIPTOR_SET 0 BINDING 2\n",
        view, constants);
    for (std::size_t i = 0; i < all.images.size(); ++i)
        text += fmt::format("  BIND BUFFER image{} AS storage DESCRIPTOR_SET 0 BINDING {}\n", i, 3 + i);
    return text + fmt::format("END\n\nRUN read_{} 1 1 1\n", view);
}

// A view of the outputs as floats or as words, because an Amber buffer has one type.
std::string view_of(const Reproduction& all, bool floats) {
    const std::string view = floats ? "floats" : "words";
    std::string text = fmt::format("BUFFER {} DATA_TYPE {} SIZE {} FILL {}\n\n", view,
                                   floats ? "float" : "uint32", all.outputs.size() + 1, floats ? "0.0" : "0");
    text += pipeline(all, view);
    text += "# the kernel ran to its end\n";
    text += fmt::format("EXPECT {} IDX {} EQ {}\n", view, 4 * all.outputs.size(),
                        floats ? "1.0" : std::to_string(one_input.canary));
    for (std::size_t i = 0; i < all.outputs.size(); ++i) {
        if (is_float(all, i) != floats) continue;
        text += fmt::format("# output {}: {}\n", i, output_comment(all, i));
        if (all.outcomes.size() > 1)
            text += fmt::format("# one of {} outcomes is allowed (report.txt); this expects their hull\n",
                                all.outcomes.size());
        for (const std::string& comparison : comparisons_of(all, i))
            text += fmt::format("EXPECT {} IDX {} {}\n", view, 4 * i, comparison);
    }
    return text + "\n";
}

}  // namespace

std::string to_amber(const Reproduction& all, const std::vector<std::string>& comments) {
    std::string text = "#!amber\n";
    for (const std::string& comment : comments) text += "# " + comment + "\n";
    // Amber ends a shader at the first "END".
    text +=
        "\nSHADER compute kernel SPIRV-ASM TARGET_ENV spv1.5\n" + base::replaced(all.assembly, "END", "End");
    if (!text.ends_with('\n')) text += '\n';
    text += "END\n\n";
    text += "# how many inputs, invocations in a row, the word to write behind the outputs\n";
    text += buffer_declaration("run", {one_input.count, one_input.row_length, one_input.canary});
    text += buffer_declaration("inputs", all.inputs);
    text += "# accesses outside an image: how many, and the first\n";
    text += buffer_declaration("faults", Words(sizeof(subject::KernelFaults) / sizeof(subject::Word)));
    for (std::size_t i = 0; i < all.images.size(); ++i) {
        text += fmt::format("# {}: width, height, clamped, then the pixels row by row\n", all.images[i].name);
        text += buffer_declaration(fmt::format("image{}", i), all.images[i].words);
    }
    const auto is = [](bool floats) {
        return [=](module::Scalar output) { return (output == module::Scalar::float_) == floats; };
    };
    for (const bool floats : {true, false})
        if (std::ranges::any_of(all.outputs, is(floats))) text += view_of(all, floats);
    if (!all.images.empty()) text += "# no access fell outside an image\nEXPECT faults IDX 0 EQ 0\n";
    return text;
}

namespace {

std::string array(const std::string& name, const Words& words) {
    std::string text = fmt::format("static const uint32_t {}[] = {{", name);
    const Words all = not_empty(words);
    for (std::size_t i = 0; i < all.size(); ++i)
        text += fmt::format("{}0x{:08x}u,", i % words_in_a_line == 0 ? "\n    " : " ", all[i]);
    return text + "\n};\n";
}

std::string number(double value) {
    if (std::isinf(value)) return value > 0.0 ? "INFINITY" : "-INFINITY";
    return fmt::format("{:.17g}", value);
}

std::string in_comment(std::string text) {
    return base::replaced(std::move(text), "*/", "* /");
}

// A literal of C. A driver may give its device any name.
std::string literal(const std::string& text) {
    constexpr std::string_view as_it_is = " ()[]<>.,:;+-_/@#=";
    std::string literal = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 0x80 && std::isalnum(byte) != 0;
        literal += plain || as_it_is.find(c) != std::string_view::npos ? std::string(1, c)
                                                                       : fmt::format("\\{:03o}", byte);
    }
    return literal + "\"";
}

std::string outputs_of(const Reproduction& check) {
    std::string text = "static const int is_float[] = {\n";
    for (std::size_t i = 0; i < check.outputs.size(); ++i)
        text += fmt::format("    {}, /* {} */\n", is_float(check, i) ? 1 : 0,
                            in_comment(output_comment(check, i)));
    text += fmt::format(
        "}};\n/* The outputs lie in the ranges of one of these. */\n"
        "struct range {{\n    double low, high;\n    int nan, repeated; /* as the range of an earlier "
        "outcome */\n}};\n"
        "static const struct range outcomes[][{}] = {{\n",
        check.outputs.size());
    std::vector<judge::Sample::Outcome> all = check.outcomes;
    if (all.empty()) all.emplace_back(check.outputs.size(), numeric::Bounds::anything());
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::vector<std::string> ranges;
        for (std::size_t i = 0; i < all[k].size(); ++i) {
            const numeric::Bounds& allowed = all[k][i];
            const bool repeated =
                std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k),
                            [&](const judge::Sample::Outcome& earlier) { return earlier[i] == allowed; });
            ranges.push_back(fmt::format("{{{}, {}, {}, {}}}", number(allowed.low), number(allowed.high),
                                         allowed.nan ? 1 : 0, repeated ? 1 : 0));
        }
        text += fmt::format("    {{{}}},\n", fmt::join(ranges, ", "));
    }
    return text + "};\n";
}

}  // namespace

std::string to_c_program(const Reproduction& all, const std::vector<std::string>& comments,
                         const std::string& device) {
    std::string text = "/*\n";
    for (const std::string& comment : comments) text += " * " + in_comment(comment) + "\n";
    text +=
        " */\n#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
        "#include <string.h>\n#include <vulkan/vulkan.h>\n\n";
    text += fmt::format("#define FOUND_ON {}\n", literal(device));
    text += fmt::format(
        "#define RUNS {}u /* inputs */\n#define JUDGED {}u /* the one that fails */\n#define ROW_LENGTH {}u\n"
        "#define SPECIALIZED {}\n#define IMAGES {}\n\n",
        all.count, all.failing, one_input.row_length, all.specialized ? 1 : 0, all.images.size());
    text += array("inputs", all.inputs);
    std::vector<std::pair<const char*, const Words*>> modules{
        {all.before.empty() ? "the module" : "after the steps", &all.spirv}};
    if (!all.before.empty() && all.before != all.spirv) modules.emplace_back("before the steps", &all.before);
    std::string list =
        "struct module {\n    const char *name;\n    const uint32_t *words;\n    size_t bytes;\n};\n"
        "static const struct module modules[] = {\n";
    for (std::size_t i = 0; i < modules.size(); ++i) {
        text += array(fmt::format("module_{}", i), *modules[i].second);
        list += fmt::format("    {{\"{0}\", module_{1}, sizeof(module_{1})}},\n", modules[i].first, i);
    }
    text += list + "};\n";
    list =
        "struct image {\n    const uint32_t *words;\n    size_t count;\n    int sampled;\n};\n"
        "static const struct image images[] = {\n";
    for (std::size_t i = 0; i < all.images.size(); ++i) {
        text += array(fmt::format("image_{}", i), all.images[i].words);
        list += fmt::format("    {{image_{0}, sizeof(image_{0}) / sizeof(image_{0}[0]), {1}}},\n", i,
                            all.images[i].bound ? 1 : 0);
    }
    return text + list + (all.images.empty() ? "    {NULL, 0, 0},\n" : "") + "};\n" + outputs_of(all) +
           internal::replay_program;
}

}  // namespace gloam::record
