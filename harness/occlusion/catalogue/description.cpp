// SPDX-License-Identifier: MIT
#include "catalogue/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace gloam::catalogue {
namespace {

namespace fs = std::filesystem;

// Takes the text up to the mark, and the mark, from the front of `text`; nothing where there is no mark.
std::optional<std::string> taken_until(std::string_view& text, std::string_view mark) {
    const std::size_t end = text.find(mark);
    if (end == std::string_view::npos) return std::nullopt;
    std::string taken(text.substr(0, end));
    text.remove_prefix(end + mark.size());
    return taken;
}

// What the first sentence of a comment says of an equation, if it is such a sentence.
std::optional<Description> described(std::string_view comment) {
    const auto name = taken_until(comment, "): `");
    const auto formula = taken_until(comment, "` [");
    const auto source = taken_until(comment, "].");
    const std::size_t bracket = name ? name->rfind(" (") : std::string::npos;
    if (!source || !formula || bracket == std::string::npos) return std::nullopt;
    if (name->find(' ', bracket + 2) != std::string::npos) return std::nullopt;  // brackets of prose
    return Description{.id = name->substr(bracket + 2),
                       .function = {},
                       .file = {},
                       .title = name->substr(0, bracket),
                       .formula = *formula,
                       .source = *source};
}

// "gloam_blend" of "vec2 gloam_blend(float history, ..."; empty for a line that begins no function.
std::string function_of(std::string_view line) {
    const std::size_t parenthesis = std::min(line.find('('), line.size());
    const std::size_t space = line.substr(0, parenthesis).rfind(' ');
    if (parenthesis == line.size() || space == std::string_view::npos) return {};
    return std::string(line.substr(space + 1, parenthesis - space - 1));
}

void read_file(const fs::path& path, const std::string& name, std::map<std::string, Description>& all) {
    std::ifstream file(path);
    std::string comment;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("// ")) {
            comment += (comment.empty() ? "" : " ") + line.substr(3);
            continue;
        }
        if (std::optional<Description> one = described(comment)) {
            one->file = name;
            one->function = function_of(line);
            if (one->function.empty())
                throw std::runtime_error(
                    fmt::format("{}: no function below the comment of {}", name, one->id));
            const auto [other, is_new] = all.emplace(one->id, *one);
            if (!is_new)
                throw std::runtime_error(fmt::format("{}: {} already describes {} of {}", name, one->id,
                                                     other->second.function, other->second.file));
        }
        comment.clear();
    }
}

}  // namespace

std::map<std::string, Description> descriptions(const fs::path& glsl) {
    std::map<std::string, Description> all;
    for (const char* folder : {"gloam", "builtin"}) {
        if (!fs::is_directory(glsl / folder))
            throw std::runtime_error(
                fmt::format("no shader library: expected the folder {}", (glsl / folder).string()));
        for (const fs::directory_entry& file : fs::recursive_directory_iterator(glsl / folder))
            if (file.path().extension() == ".glsl")
                read_file(file.path(), fs::relative(file.path(), glsl).generic_string(), all);
    }
    return all;
}

}  // namespace gloam::catalogue
