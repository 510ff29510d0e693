// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/image_files.hpp"
#include "catalogue/entry.hpp"
#include "check/prepared_check.hpp"
#include "effect/methods.hpp"
#include "scene/scene.hpp"
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
    // Compressed, as base64: gloam.values() reads it.
    [[nodiscard]] std::string text() const { return base::deflated_base64(bytes_); }

  private:
    std::vector<unsigned char> bytes_;
};

// A prepared check as JSON for the page (page/judge.js reads it). Words and doubles are base64 of
// their little-endian bytes, compressed.
[[nodiscard]] std::string check_json(const catalogue::Description& description,
                                     const check::Question& question, const check::PreparedCheck& prepared);

// The folders of the shaders that the effect of the page is made from.
struct ShaderFolders {
    std::filesystem::path library;  // with gloam/ and passes/
    std::filesystem::path page;     // with whole_image.vert
};

// What AmbientOcclusion needs (effect/ambient-occlusion.js), as JSON: gloam's own presets, and the passes by
// name. Throws like shader::pack().
[[nodiscard]] std::string effect_json(const ShaderFolders& folders);

// The passes that draw a scene of the page and show it (page/picture.js), by name, as JSON.
[[nodiscard]] std::string picture_json(const ShaderFolders& folders);

// The classes of the effect in WebGL2 (effect/*.js): JavaScript that defines AmbientOcclusion and what it
// uses. Throws std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string effect_classes(const std::filesystem::path& folder);

// The triangles of a scene and its camera in each of `frames` frames, as JSON (page/scene.js).
[[nodiscard]] std::string scene_json(const scene::Scene& scene, int frames);

// What the page of methods shows below its title, as HTML: each with its picture, then all in a table.
// failures: a page with the table "method | fails | number", as docs/methods.md has it. caption: of their
// pictures; empty: there are none. Throws std::runtime_error where there is no such table, and like
// shader::pack().
[[nodiscard]] std::string methods_html(const std::vector<effect::MethodInfo>& methods,
                                       const std::filesystem::path& library, std::string_view failures,
                                       const std::string& caption);

}  // namespace gloam::site
