// SPDX-License-Identifier: MIT
#include "shader/internal/comments.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

#include "shader/internal/lines.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;

// The lines of comments before the first line of code.
std::string leading_comment(const std::string& text) {
    std::string comment;
    for (const Line& line : split_lines(text)) {
        if (!is_blank(line)) break;
        comment += std::string(line.text);
        if (!comment.ends_with('\n')) comment += '\n';
    }
    return comment;
}

// The name that a line of code declares: the last word before a '[', a '=' or the ';'.
std::string declared_by(const std::string& line) {
    static const std::regex layout(R"(layout\s*\([^)]*\))");
    const std::string code = std::regex_replace(line, layout, "");
    static const std::regex declared(R"((\w+)\s*(\[[^\]]*\]\s*)*(=[^;]*)?;)");
    std::smatch found;
    return std::regex_search(code, found, declared) ? found[1].str() : "";
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

// The name of a type of HLSL and MSL: "vec2" is "float2", "mat4" is "float4x4".
std::string translated_type(const std::string& type) {
    static const std::regex vector("([biu]?)vec([234])");
    static const std::regex matrix("mat([234])(x[234])?");
    std::smatch found;
    if (std::regex_match(type, found, vector)) {
        const std::string kind = found[1];
        const char* scalar = kind == "b" ? "bool" : kind == "i" ? "int" : kind == "u" ? "uint" : "float";
        return scalar + found[2].str();
    }
    if (std::regex_match(type, found, matrix))
        return "float" + found[1].str() + (found[2].matched ? found[2].str() : "x" + found[1].str());
    return type;
}

// The comment behind each declared name. A line that has nothing but a comment, further to the right than the
// declarations, continues the comment before it.
void add_members(const std::string& text, std::map<std::string, std::string>& behind) {
    std::string last;
    std::size_t column = 0;
    for (const Line& line : split_lines(text)) {
        const std::string comment = trimmed(comments_of(line));
        const std::string declared = declared_by(line.code);
        const std::size_t first = line.text.find_first_not_of(" \t");
        if (!declared.empty() && declared != "}") {
            last = comment.empty() ? "" : declared;
            column = first;
            behind[declared] = comment;
        } else if (!last.empty() && !comment.empty() && is_blank(line) && first > column) {
            behind[last] += "\n" + comment;
        } else {
            last.clear();
        }
    }
}

}  // namespace

Comments::Comments(const Outline& glsl) {
    for (const Piece& piece : glsl.pieces) {
        if (piece.names.empty()) continue;
        const std::string comment = leading_comment(piece.text);
        const std::string& name = piece.names.front();
        if (piece.kind == Kind::function || piece.kind == Kind::prototype) {
            OfFunction own{.parameters = {}, .comment = comment};
            for (const std::string& word : piece.parameter_types)
                own.parameters.push_back(translated_type(word));
            if (!comment.empty()) functions_.emplace(name, std::move(own));
            continue;
        }
        for (const std::string& each : piece.names) above_[each] = comment;
        instances_[name].assign(piece.names.begin() + 1, piece.names.end());
        const bool one_line = piece.text.find('{') == std::string::npos;
        add_members(piece.text, behind_[one_line ? "" : name]);
    }
}

std::string Comments::above_function(const Piece& translated) const {
    const auto [first, end] = functions_.equal_range(translated.names.front());
    std::string best;
    std::ptrdiff_t most = -1;
    for (auto each = first; each != end; ++each) {
        const auto same = std::ranges::count_if(each->second.parameters, [&](const std::string& word) {
            return std::ranges::find(translated.parameter_types, word) != translated.parameter_types.end();
        });
        if (same > most) best = each->second.comment;
        most = std::max<std::ptrdiff_t>(most, same);
    }
    return best;
}

std::string Comments::above(const std::string& name) const {
    const auto found = above_.find(name);
    return found == above_.end() ? "" : found->second;
}

std::string Comments::behind(const std::string& block, const std::string& member) const {
    const auto found = behind_.find(block);
    if (found == behind_.end()) return "";
    const auto comment = found->second.find(member);
    return comment == found->second.end() ? "" : comment->second;
}

std::vector<std::string> Comments::instances(const std::string& block) const {
    const auto found = instances_.find(block);
    return found == instances_.end() ? std::vector<std::string>{} : found->second;
}

}  // namespace gloam::shader::internal
