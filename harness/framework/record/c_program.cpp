// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "record/failures.hpp"
#include "record/replay_text.hpp"
#include "judge/reproduction.hpp"

namespace gloam::record {
namespace {

using Words = std::vector<std::uint32_t>;

std::string array(const std::string& name, const Words& words) {
    constexpr std::size_t in_a_line = 8;
    std::string text = fmt::format("static const uint32_t {}[] = {{", name);
    const Words one{0U};  // no array is empty
    const Words& all = words.empty() ? one : words;
    for (std::size_t i = 0; i < all.size(); ++i)
        text += fmt::format("{}0x{:08x}u,", i % in_a_line == 0 ? "\n    " : " ", all[i]);
    return text + "\n};\n";
}

std::string number(double value) {
    if (std::isinf(value)) return value > 0.0 ? "INFINITY" : "-INFINITY";
    return fmt::format("{:.17g}", value);
}

std::string in_comment(std::string text) {
    for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;) text.replace(at, 2, "* /");
    return text;
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

std::string outputs_of(const KernelReplay& replay) {
    std::string text = "static const int is_float[] = {\n";
    for (const KernelReplay::Output& output : replay.outputs)
        text += fmt::format("    {}, /* {} */\n", output.is_float ? 1 : 0, in_comment(output.comment));
    text += fmt::format(
        "}};\n/* The outputs lie in the ranges of one of these. */\n"
        "struct range {{\n    double low, high;\n    int nan, repeated; /* as the range of an earlier "
        "outcome */\n}};\n"
        "static const struct range outcomes[][{}] = {{\n",
        replay.outputs.size());
    const std::vector<check::Sample::Outcome> anything{
        check::Sample::Outcome(replay.outputs.size(), numeric::Bounds::anything())};
    const std::vector<check::Sample::Outcome>& all = replay.outcomes.empty() ? anything : replay.outcomes;
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::vector<std::string> ranges;
        for (std::size_t i = 0; i < all[k].size(); ++i) {
            const numeric::Bounds& allowed = all[k][i];
            const bool repeated =
                std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k),
                            [&](const check::Sample::Outcome& earlier) { return earlier[i] == allowed; });
            ranges.push_back(fmt::format("{{{}, {}, {}, {}}}", number(allowed.low), number(allowed.high),
                                         allowed.nan ? 1 : 0, repeated ? 1 : 0));
        }
        text += fmt::format("    {{{}}},\n", fmt::join(ranges, ", "));
    }
    return text + "};\n";
}

}  // namespace

std::string to_c_program(const KernelReplay& replay, const std::vector<ReplayedModule>& modules) {
    std::string text = "/*\n";
    for (const std::string& comment : replay.comments) text += " * " + in_comment(comment) + "\n";
    text +=
        " */\n#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
        "#include <string.h>\n#include <vulkan/vulkan.h>\n\n";
    text += fmt::format("#define FOUND_ON {}\n", literal(replay.device));
    text += fmt::format("#define ROW_LENGTH {}u\n#define SPECIALIZED {}\n#define IMAGES {}\n\n",
                        check::kernel_group_size, replay.specialized ? 1 : 0, replay.images.size());
    text += array("inputs", replay.inputs);
    std::string list =
        "struct module {\n    const char *name;\n    const uint32_t *words;\n    size_t bytes;\n};\n"
        "static const struct module modules[] = {\n";
    for (std::size_t i = 0; i < modules.size(); ++i) {
        text += array(fmt::format("module_{}", i), modules[i].words);
        list += fmt::format("    {{\"{0}\", module_{1}, sizeof(module_{1})}},\n", modules[i].name, i);
    }
    text += list + "};\n";
    list =
        "struct image {\n    const uint32_t *words;\n    size_t count;\n    int sampled;\n};\n"
        "static const struct image images[] = {\n";
    for (std::size_t i = 0; i < replay.images.size(); ++i) {
        const KernelReplay::Image& image = replay.images[i];
        text += array(fmt::format("image_{}", i), image.words);
        list += fmt::format("    {{image_{0}, sizeof(image_{0}) / sizeof(image_{0}[0]), {1}}},\n", i,
                            image.sampled ? 1 : 0);
    }
    return text + list + (replay.images.empty() ? "    {NULL, 0, 0},\n" : "") + "};\n" + outputs_of(replay) +
           replay_program;
}

}  // namespace gloam::record
