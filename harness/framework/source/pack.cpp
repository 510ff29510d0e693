// SPDX-License-Identifier: MIT
#include "source/pack.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <set>

#include "base/pattern.hpp"
#include "source/internal/selection.hpp"

namespace gloam::source {
namespace {

void add_block(std::string& text, const std::string& block, bool apart = true) {
    text += (apart ? "\n\n" : "\n") + block;
}

// A value as GLSL writes it.
std::string literal(const std::string& type, std::uint32_t bits) {
    if (type == "bool") return bits != 0 ? "true" : "false";
    if (type == "uint") return std::to_string(bits) + "u";
    if (type == "int") return std::to_string(std::bit_cast<std::int32_t>(bits));
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::bit_cast<float>(bits)).ptr;
    const std::string digits(text.data(), end);
    return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}

// The declaration of a specialization constant with the value asked for.
std::string with_value(const std::string& text, const std::map<std::uint32_t, std::uint32_t>& constants) {
    static const base::Pattern declaration(
        R"((constant_id\s*=\s*(\d+)\s*\)\s*const\s+(bool|int|uint|float)\s+\w+\s*=\s*)[^;]+)");
    const std::vector<std::string> found =
        constants.empty() ? std::vector<std::string>{} : declaration.first(text);
    if (found.empty()) return text;
    const auto value = constants.find(static_cast<std::uint32_t>(std::stoul(found[2])));
    if (value == constants.end()) return text;
    std::string given = text;
    return given.replace(text.find(found[0]), found[0].size(), found[1] + literal(found[3], value->second));
}

// Interfaces as OpenGL has them: constants of their values, and a uniform block in the place of push
// constants. The members that push constants may have here have the same offsets in std140.
std::string for_opengl(const std::string& text) {
    static const base::Pattern constant(R"(layout\s*\(\s*constant_id\s*=\s*\d+\s*\)\s*const\b)");
    static const base::Pattern pushed(R"(layout\s*\(\s*push_constant\s*\)\s*uniform\b)");
    return pushed.replaced(constant.replaced(text, "const"), "layout(binding = 0, std140) uniform");
}

std::string written(const Outline& outline, const std::vector<const Declaration*>& kept,
                    const PackRequest& request, const std::string& head) {
    const std::string preamble = source::preamble(request.language);
    const std::size_t version = preamble.find('\n');
    std::string text = preamble.substr(0, version);
    for (const auto& lines : {outline.licences, outline.extensions})
        for (const std::string& line : lines) add_block(text, line, false);
    if (version + 1 < preamble.size())
        add_block(text, preamble.substr(version + 1, preamble.size() - version - 2), false);
    if (!head.empty() && std::ranges::count(outline.heads, head) == 0) add_block(text, head);
    for (const std::string& own : outline.heads) add_block(text, own);
    const Declaration* before = nullptr;
    for (const Declaration* one : kept) {
        const bool same = before && before->paragraph == one->paragraph && before->file == one->file;
        const bool adjustable = one->kind == Declaration::Kind::interface;
        const std::string set = adjustable ? with_value(one->text, request.constants) : one->text;
        const bool vulkan = request.language == Language::vulkan450;
        add_block(text, adjustable && !vulkan ? for_opengl(set) : set, !same);
        before = one;
    }
    return text + "\n";
}

}  // namespace

Packed packed(const ActiveText& texts, const PackRequest& request) {
    const Outline outline = source::outline(texts);
    const Kept kept = kept_in_order(outline, texts.given, request.functions);
    const bool has_main = std::ranges::find(kept.wanted, "main") != kept.wanted.end();
    const std::string head = has_main ? "" : calling_comment(kept);
    return {written(outline, kept.declarations, request, head), has_main};
}

std::string code_of(std::string_view text) {
    std::string all;
    for (Line& line : split_lines(text)) {
        std::erase(line.code, '\0');
        const std::string_view code = trimmed(line.code);
        if (!code.empty()) all.append(code).append("\n");
    }
    return all;
}

std::size_t code_lines(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count(code_of(text), '\n'));
}

std::size_t code_lines(const std::vector<std::string>& packed) {
    std::set<std::string> counted;
    std::size_t all = 0;
    for (const std::string& text : packed) {
        const Outline outline = source::outline(whole_text(text));
        all += outline.extensions.size();
        for (const Declaration& one : outline.declarations) {
            const bool directive = one.tokens.empty();
            const bool own =
                directive ? one.text.starts_with("#version")
                          : one.tokens.front() == "layout" || (one.function && one.function->name == "main");
            if (own || counted.insert(directive ? one.text : joined(one.tokens, " ")).second)
                all += code_lines(one.text);
        }
    }
    return all;
}

}  // namespace gloam::source
