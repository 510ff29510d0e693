// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "shader/compile.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

// A pass of the page: a text with loose uniforms, as OpenGL ES has them, and the specialization constants of
// Vulkan.
struct PassText {
    std::string name;
    std::string text;
    shader::Stage stage = shader::Stage::fragment;
};

// The pass as an executor of the API takes it, packed. WebGL2: its text in GLSL ES 3.00. WebGPU: an object:
//   text       in WGSL
//   bytes      of its uniform buffer, which has binding 0; 0: it has none
//   values     of the buffer: [name, type of GLSL, offset] of each, those of structures by their own names
//   images     [name, binding] of each
//   constants  {name: number} of those that the user may set
// The group of a vertex shader is 1, that of a fragment shader 0. Throws like shader::pack() and
// shader::translated().
[[nodiscard]] nlohmann::ordered_json pass_json(const PassText& pass, Api api, const ShaderFolders& folders);

// The text as Vulkan has it: uniforms in one buffer, with numbers of bindings and locations.
[[nodiscard]] std::string for_vulkan(const PassText& pass);

}  // namespace gloam::site
