// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "catalogue/entry.hpp"
#include "check/prepared_check.hpp"
#include "effect/methods.hpp"
#include "scene/scene.hpp"
#include "shader/compile.hpp"
#include "site/site.hpp"

namespace gloam::site {

// Little-endian bytes of values one after another, which the pages read.
class Bytes {
  public:
    template <class T>
    void add(T value) {
        static_assert(std::endian::native == std::endian::little);
        const auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    // As base64.
    [[nodiscard]] std::string text() const { return base::base64(bytes_); }

  private:
    std::vector<unsigned char> bytes_;
};

// A prepared check as JSON for the page (page/judge.js reads it). Words and doubles are base64 of
// their little-endian bytes.
[[nodiscard]] std::string check_json(const catalogue::Description& description,
                                     const check::Question& question, const check::PreparedCheck& prepared);

// The folders of the shaders that the effect of the page is made from.
struct ShaderFolders {
    std::filesystem::path library;  // with gloam/ and passes/
    std::filesystem::path page;     // with occlusion.frag
};

// What AmbientOcclusion needs (effect/ambient-occlusion.js), as JSON: gloam's own presets, their methods, and
// the passes by name. Throws like shader::pack().
[[nodiscard]] std::string effect_json(const ShaderFolders& folders);

// The passes that draw a scene of the page and show it (page/picture.js), by name, as JSON.
[[nodiscard]] std::string picture_json(const ShaderFolders& folders);

// The classes of the effect in WebGL2 (effect/*.js): JavaScript that defines AmbientOcclusion and what it
// uses. Throws std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string effect_classes(const std::filesystem::path& folder);

// The triangles of a scene and its camera in each of `frames` frames, as JSON (page/scene.js).
[[nodiscard]] std::string scene_json(const scene::Scene& scene, int frames);

// Where a method fails, in words, and by how much.
struct MethodFailure {
    std::string words;
    std::string number;
};

// Of the methods that the table "method | fails | number" of a page names: docs/methods.md has it. Throws
// std::runtime_error where there is no such table.
[[nodiscard]] std::map<std::string, MethodFailure> method_failures(std::string_view markdown);

// The equations of occlusion that a method's function uses, its own first. equations: of the library, which
// is the folder. Throws like shader::pack().
[[nodiscard]] std::vector<catalogue::Description> method_equations(
    const effect::MethodInfo& method, const std::filesystem::path& library,
    const std::map<std::string, catalogue::Description>& equations);

// What the page of methods says of one, as JSON (page/methods.js). equations: those that it uses.
// caption: of its picture; empty: there is none.
[[nodiscard]] std::string method_json(const effect::MethodInfo& method,
                                      const std::vector<catalogue::Description>& equations,
                                      const MethodFailure& failure, const std::string& caption);

// A GLSL text without its comments, indents and blank lines. Other lines stay lines of their own. Where it
// defines no macro, it is also without #undef lines.
[[nodiscard]] std::string condensed(std::string_view text);

// A pass of the page: a text with loose uniforms, as OpenGL ES has them, and the specialization constants of
// Vulkan.
struct PassText {
    std::string name;
    std::string text;
    shader::Stage stage = shader::Stage::fragment;
};

// The pass as one text in GLSL ES 3.00, condensed. Throws like shader::pack().
[[nodiscard]] std::string pass_text(const PassText& pass, const ShaderFolders& folders);

}  // namespace gloam::site
