// SPDX-License-Identifier: MIT
#include "catalogue/document.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gloam::catalogue {
namespace {

constexpr std::string_view introduction =
    "# Equations\n\n"
    "Generated from the catalogue by `gloam list equations --markdown`; a test compares the two.\n\n"
    "Conventions: *occlusion* is 1 where blocked, *visibility* 1 where open. View space is right-handed and "
    "looks down -z;\n"
    "depth d = -z is eye-linear. A background pixel has depth +infinity; 0, negative and NaN depths are read "
    "the same way.\n"
    "*Error* is what the function may differ from the exact mathematics: an output is within it when it is "
    "within the ULP\n"
    "bound or within the absolute bound. The comment above each function states its parameters and edge "
    "cases.\n";

// "gloam/temporal/blend.glsl" -> "temporal".
std::string room_of(const std::string& file) {
    const std::size_t begin = file.find('/') + 1;
    return file.substr(begin, file.find('/', begin) - begin);
}

// GLSL's own functions have no accuracy of their own: a line each.
std::string rules_table(const Entries& entries) {
    std::string text =
        "\n## GLSL's own operators and functions\n\n"
        "What Vulkan promises of them, in [Precision and Operation of SPIR-V Instructions]"
        "(https://registry.khronos.org/vulkan/specs/latest/html/vkspec.html#spirvenv-precision-operation); a "
        "device is\njudged by that alone. The probes ask what is not promised, or was got wrong by some "
        "driver or "
        "compiler.\n\n"
        "| entry | expression | |\n| --- | --- | --- |\n";
    for (const Entry& entry : entries) {
        const Description& d = entry.description;
        if (entry.question.only_rules) {
            text += fmt::format("| {} | `{}` | {} |\n", d.id, d.formula, d.title);
        }
    }
    return text;
}

std::string section(const Entry& entry) {
    const Description& d = entry.description;
    return fmt::format("\n### {}: {}\n\n    {}\n\n`{}` in [{}](../glsl/{})  \nError: {}. Source: {}.\n", d.id,
                       d.title, d.formula, check::to_glsl(entry.question.signature, d.function), d.file,
                       d.file, check::to_text(entry.question.budget), d.source);
}

}  // namespace

std::string to_markdown(const Entries& entries) {
    std::string text(introduction);
    std::string room;
    for (const Entry& entry : entries) {
        if (entry.question.only_rules) continue;
        if (room_of(entry.description.file) != room) {
            room = room_of(entry.description.file);
            text += fmt::format("\n## {}\n", room);
        }
        text += section(entry);
    }
    if (std::ranges::any_of(entries, [](const Entry& entry) { return entry.question.only_rules; })) {
        text += rules_table(entries);
    }
    return text;
}

}  // namespace gloam::catalogue
