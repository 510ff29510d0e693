// SPDX-License-Identifier: MIT
#include "source/plain_global.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace gloam::source::internal {
namespace {

bool is_dropped(const Token& token) {
    constexpr std::array words{"uniform",  "buffer",   "in",        "out",      "attribute",
                               "varying",  "flat",     "smooth",    "centroid", "noperspective",
                               "sample",   "patch",    "shared",    "coherent", "volatile",
                               "restrict", "readonly", "writeonly", "invariant"};
    return std::ranges::find(words, token.text) != words.end();
}

bool is_precision(const Token& token) {
    return token == "highp" || token == "mediump" || token == "lowp";
}

// The tokens without layouts and storage qualifiers; an array without a size ("float values[];": as many as
// its buffer holds) gets one.
std::vector<Token> without_qualifiers(Tokens tokens) {
    constexpr const char* runtime_array_length = "16";
    std::vector<Token> kept;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] == "layout" && i + 1 < tokens.size() && tokens[i + 1] == "(") {
            i = behind(tokens, i + 1) - 1;
            continue;
        }
        if (tokens[i] == "]" && tokens[i - 1] == "[") kept.push_back({runtime_array_length});
        if (!is_dropped(tokens[i])) kept.push_back(tokens[i]);
    }
    return kept;
}

// The same list of declarators without their initial values.
std::vector<Token> without_values(Tokens tokens) {
    std::vector<Token> kept;
    bool value = false;
    for (std::size_t i = 0; i < tokens.size();) {
        const std::size_t end = behind(tokens, i);
        if (tokens[i] == "=") value = true;
        if (tokens[i] == "," || tokens[i] == ";") value = false;
        if (!value) std::ranges::copy(tokens.subspan(i, end - i), std::back_inserter(kept));
        i = end;
    }
    return kept;
}

// Directives between the lines of a declaration, each on its own line.
std::string directives_of(const std::string& text) {
    std::string all;
    for (const Line& line : split_lines(text)) {
        const auto directive = directive_of(line);
        if (directive && directive->keyword != "line") all += std::string(line.text) + "\n";
    }
    return all.empty() ? all : "\n" + all;
}

// The format of a declaration of an image, if its texels have 32 bits; empty for another. An image that is
// only written needs none.
std::string image_format(Tokens tokens, std::string_view type) {
    const std::string suffix = type.starts_with('u') ? "32ui" : type.starts_with("ii") ? "32i" : "32f";
    for (const char* channels : {"r", "rg", "rgba"})
        if (contains(tokens, channels + suffix)) return channels + suffix;
    const bool other = std::ranges::any_of(tokens, [](const Token& token) {
        return token.text.starts_with("r") && token.text.find_first_of("0123456789") != std::string::npos;
    });
    return contains(tokens, "writeonly") && !other ? "rgba" + suffix : std::string();
}

Access access_of(Tokens head) {
    const bool fixed = contains(head, "readonly");
    if (contains(head, "buffer")) return fixed ? Access::uniform : Access::buffer;
    if (contains(head, "out") || contains(head, "varying")) return Access::any;
    return contains(head, "uniform") ? Access::uniform : Access::reads;
}

}  // namespace

bool is_opaque(std::string_view word) {
    constexpr std::array families{"sampler",      "image",       "texture",
                                  "subpassInput", "atomic_uint", "accelerationStructure"};
    const bool of_integers = (word.starts_with('i') && !word.starts_with("image")) || word.starts_with('u');
    if (of_integers) word.remove_prefix(1);
    return std::ranges::any_of(families, [&](const char* family) { return word.starts_with(family); });
}

std::optional<std::vector<BoundVariable>> bound_variables(const Declaration& one,
                                                          const std::map<std::string, std::string>& opaque) {
    const Tokens all = one.tokens;
    const std::vector<Token> words = without_qualifiers(all);
    const auto type = std::ranges::find_if_not(words, is_precision);
    if (type == words.end() || contains(words, "{")) return std::nullopt;
    const auto macro = opaque.find(type->text);
    const std::string& name = macro == opaque.end() ? type->text : macro->second;
    BoundVariable variable{.name = {}, .type = name, .written = !contains(all, "readonly")};
    if (name.ends_with("image2D")) variable.format = image_format(up_to(all, type->text), name);
    if (!is_sampler_type(name) && variable.format.empty()) return std::nullopt;
    if (contains(words, "[")) return std::nullopt;  // an array of samplers
    std::vector<BoundVariable> variables;
    for (const std::string& own : one.names) {
        variable.name = own;
        variables.push_back(variable);
    }
    return variables;
}

std::string image_macros() {
    const std::string layer = image_layer;
    std::string text = "int " + layer + ";\n";
    const auto macro = [&](const std::string& name, const std::string& values) {
        text += "#define " + name + "(image, at" + values + ") " + name + "(image, ivec3(at, " + layer + ")" +
                values + ")\n";
    };
    text += "#define imageSize(image) imageSize(image).xy\n";
    macro("imageLoad", "");
    macro("imageStore", ", value");
    for (const char* operation : {"Add", "Min", "Max", "And", "Or", "Xor", "Exchange"})
        macro(std::string("imageAtomic") + operation, ", value");
    macro("imageAtomicCompSwap", ", compare, value");
    return text;
}

std::optional<PlainGlobals> plain_globals(const Declaration& one,
                                          const std::map<std::string, std::string>& opaque) {
    const std::vector<Token> kept = without_qualifiers(one.tokens);
    if (contains(one.tokens, "constant_id")) return PlainGlobals{joined(kept, " "), {}};
    if (one.names.empty() || one.names.front().starts_with("gl_")) return std::nullopt;
    if (contains(one.tokens, "buffer_reference")) return std::nullopt;
    const Access access = access_of(up_to(one.tokens, "{"));
    const std::vector<Token> words = without_values(kept);
    const Tokens tokens = words;
    PlainGlobals globals{directives_of(one.text), {}};
    const std::size_t brace = up_to(tokens, "{").size();
    if (brace == tokens.size()) {
        const auto type = std::ranges::find_if_not(words, is_precision);
        if (type == words.end() || is_opaque(type->text) || opaque.contains(type->text)) return std::nullopt;
        globals.text += joined(words, " ");
        for (const std::string& name : one.names) globals.access[name] = access;
        return globals;
    }
    const std::size_t end = behind(tokens, brace);
    const bool structure = contains(tokens.first(brace), "struct");
    const bool instance = end < tokens.size() && tokens[end] != ";";
    if (structure || instance) {
        globals.text += (structure ? "" : "struct ") + joined(tokens, " ");
        globals.access[tokens[end].text] = access;
    } else {
        globals.text += joined(tokens.subspan(brace + 1, end - brace - 2), " ");
        // The name of the block is first among the names.
        for (std::size_t i = 1; i < one.names.size(); ++i) globals.access[one.names[i]] = access;
    }
    return globals;
}

}  // namespace gloam::source::internal
