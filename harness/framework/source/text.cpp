// SPDX-License-Identifier: MIT
#include "source/text.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace gloam::source {
namespace {

// The default of sampler2D is lowp: depths would lose most of their bits.
constexpr const char* es_precisions =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

// What OpenGL 3.2 lacks: locations of outputs, and bits of floats.
constexpr const char* extensions_of_150 =
    "#extension GL_ARB_explicit_attrib_location : require\n"
    "#extension GL_ARB_shader_bit_encoding : require\n";

struct Entry {
    const char* name;
    const char* version;
    const char* start;  // behind #version
    Stage stage;
};

// In the order of Language.
constexpr std::array entries{Entry{"450", "450", "", Stage::compute},
                             Entry{"430", "430 core", "", Stage::compute},
                             Entry{"330", "330 core", "", Stage::fragment},
                             Entry{"150", "150 core", extensions_of_150, Stage::fragment},
                             Entry{"300es", "300 es", es_precisions, Stage::fragment},
                             Entry{"310es", "310 es", es_precisions, Stage::compute},
                             Entry{"320es", "320 es", es_precisions, Stage::compute}};

const Entry& entry_of(Language language) {
    return entries.at(static_cast<std::size_t>(language));
}

}  // namespace

std::optional<Language> language_from(std::string_view name) {
    const auto found = std::ranges::find(entries, name, &Entry::name);
    return found == entries.end() ? std::nullopt : std::optional(Language(found - entries.begin()));
}

std::string to_string(Language language) {
    return entry_of(language).name;
}

std::string preamble(Language language) {
    const Entry& entry = entry_of(language);
    return "#version " + std::string(entry.version) + "\n" + entry.start;
}

Stage usual_stage(Language language) {
    return entry_of(language).stage;
}

bool is_sampler_type(std::string_view name) {
    if (name == "sampler2DShadow") return true;
    if (name.starts_with('i') || name.starts_with('u')) name.remove_prefix(1);
    constexpr std::array<std::string_view, 5> known{"sampler2D", "sampler2DArray", "sampler3D", "samplerCube",
                                                    "samplerCubeArray"};
    return std::ranges::find(known, name) != known.end();
}

bool is_opaque(std::string_view word) {
    constexpr std::array families{"sampler",      "image",       "texture",
                                  "subpassInput", "atomic_uint", "accelerationStructure"};
    const bool of_integers = (word.starts_with('i') && !word.starts_with("image")) || word.starts_with('u');
    if (of_integers) word.remove_prefix(1);
    return std::ranges::any_of(families, [&](const char* family) { return word.starts_with(family); });
}

std::optional<Stage> stage_of_file(const std::filesystem::path& file) {
    const std::string ending = base::lower(file.extension().string());
    if (ending == ".comp" || ending == ".cs") return Stage::compute;
    if (ending == ".vert" || ending == ".vs" || ending == ".vsh") return Stage::vertex;
    if (ending == ".frag" || ending == ".fs" || ending == ".fsh") return Stage::fragment;
    return std::nullopt;
}

}  // namespace gloam::source
