// SPDX-License-Identifier: MIT
#include "shader/internal/version_line.hpp"

#include <algorithm>
#include <sstream>

#include "shader/internal/lines.hpp"

namespace gloam::shader::internal {
namespace {

constexpr std::string_view accepted[] = {"430",      "440",      "450",      "460",    "430 core",
                                         "440 core", "450 core", "460 core", "310 es", "320 es"};

std::string with_single_blanks(const std::string& text) {
    std::istringstream words(text);
    std::string joined;
    for (std::string word; words >> word;) joined.append(joined.empty() ? "" : " ").append(word);
    return joined;
}

}  // namespace

void require_vulkan_version(const Source& source) {
    int number = 1;
    std::string found = "none";
    for (const Line& line : split_lines(source.text)) {
        if (is_blank(line)) continue;
        number = line.number;
        const auto directive = directive_of(line);
        if (!directive || directive->keyword != "version") break;
        found = with_single_blanks(directive->argument);
        if (std::find(std::begin(accepted), std::end(accepted), found) != std::end(accepted)) return;
        break;
    }
    throw CompileError(source.name + ":" + std::to_string(number) +
                       ": the text must start with #version 430 to 460 (core), 310 es or 320 es; found " +
                       found);
}

}  // namespace gloam::shader::internal
