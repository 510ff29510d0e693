// SPDX-License-Identifier: MIT
#include "subject/internal/refused.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string_view>

#include "source/tokens.hpp"

namespace gloam::check::internal {
namespace {

// A variable of GLSL 1.20 that later versions have not.
bool is_legacy(std::string_view name) {
    constexpr std::array<std::string_view, 20> beginnings{
        "gl_ModelView", "gl_Projection", "gl_Normal",    "gl_TextureMatrix", "gl_MultiTexCoord",
        "gl_TexCoord",  "gl_Color",      "gl_Secondary", "gl_Front",         "gl_Back",
        "gl_FogCoord",  "gl_FogFrag",    "gl_Fog",       "gl_Light",         "gl_FragData",
        "gl_ClipPlane", "gl_ClipVertex", "gl_Point",     "gl_TextureEnv",    "gl_MaxLights"};
    if (name == "gl_Vertex" || name == "ftransform") return true;
    return std::ranges::any_of(beginnings, [&](auto beginning) { return name.starts_with(beginning); });
}

// A word of HLSL; empty if the text has none.
std::string word_of_hlsl(const std::string& text) {
    static const std::regex words(R"(\b(float[234](x[234])?|half[234]|int[234]|uint[234]|cbuffer|SV_\w+)\b)");
    std::smatch found;
    return std::regex_search(text, found, words) ? found.str() : "";
}

// A reference to a buffer as a type of the excerpt, which lacks it.
std::string pointer_of(const shader::Excerpt& excerpt) {
    if (excerpt.text.find("GL_EXT_buffer_reference") == std::string::npos) return {};
    const std::vector<shader::Token> tokens = shader::tokens_of(excerpt.text);
    const auto found = std::ranges::adjacent_find(tokens, [&](const auto& type, const auto& name) {
        return excerpt.interface.contains(type.text) && name.is_word();
    });
    return found == tokens.end() ? "" : found->text;
}

}  // namespace

LeftOut refused(const shader::Excerpt& excerpt, const std::string& definition, const std::string& errors) {
    const std::string first = errors.substr(0, errors.find('\n'));
    std::istringstream parts(first);  // "own.frag:10: 'image' : undeclared identifier"
    std::string place;
    std::string name;
    std::getline(parts, place, '\'');
    std::getline(parts, name, '\'');
    place.erase(place.find_last_not_of(": ") + 1);
    const auto is = [&first](const char* text) { return first.find(text) != std::string::npos; };
    const bool lacks = excerpt.interface.contains(name);
    if (const std::string type = pointer_of(excerpt); !type.empty() && (lacks || is("syntax error")))
        return {definition,
                fmt::format("gloam cannot run it: {}, at {}, is a reference to memory (buffer_reference)",
                            type, place)};
    if (lacks)
        return {
            definition,
            fmt::format("it uses \"{}\", an image or sampler, at {}; expected no array, but one of {}, an "
                        "image2D with a format of 32 bits like r32f, or values from parameters and "
                        "prototypes T name(ivec2)",
                        name, place, judged_samplers)};
    if (is_legacy(name))
        return {definition,
                fmt::format("\"{}\" at {} is of GLSL 1.20; pass its value as a parameter or a uniform", name,
                            place)};
    if (const std::string word = word_of_hlsl(excerpt.text); !word.empty())
        return {definition, fmt::format("it is HLSL (\"{}\"), and gloam reads GLSL: {}", word, first), true};
    if (is("not supported in this stage") || (name.starts_with("gl_") && is("undeclared identifier")))
        return {definition,
                fmt::format("{} at {} needs another stage than compute and fragment", name, place)};
    if (is("Atomic memory function") || is("atomic memory functions"))
        return {definition,
                fmt::format("{} at {} needs memory that invocations share: each input is run by itself", name,
                            place)};
    return {definition, "it does not compile: " + first, true};
}

}  // namespace gloam::check::internal
