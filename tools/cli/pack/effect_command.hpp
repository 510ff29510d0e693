// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shader/translate.hpp"

namespace gloam::cli {

struct EffectPackOptions {
    std::string preset = "balanced";
    std::string method;            // empty: the preset's
    float radius = 1.0F;           // world units
    std::vector<std::string> set;  // NAME=VALUE
    std::string size = "1920x1080";
    bool moving_objects = false;
    bool orthographic = false;
    bool reconstruct_normals = false;
    bool tiles = false;
    std::string depth = "linear";  // how the engine stores depth and normals: scene::encoding_named()
    std::string normals = "view";
    std::optional<shader::Target> target;  // a language for every pass, besides GLSL
    std::string version = "450";           // of the passes: or 310es, 320es
    std::filesystem::path out;
};

// Writes all passes of the effect, gloam_effect.h, effect.json and README.md into a folder, all or none.
// Throws std::invalid_argument for invalid options, std::runtime_error for a folder that cannot be written
// to.
void pack_effect(const EffectPackOptions& options);

}  // namespace gloam::cli
