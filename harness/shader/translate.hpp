// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shader/compile.hpp"

namespace gloam::shader {

// Shading languages other than GLSL.
enum class Target { hlsl, msl, wgsl };

// "hlsl", "msl", "wgsl"; nullopt for other text.
[[nodiscard]] std::optional<Target> target_from(std::string_view name);

// The suffix of a file: ".hlsl", ".metal", ".wgsl".
[[nodiscard]] std::string suffix(Target target);

// A text that pack() wrote for Vulkan, translated by SPIRV-Cross: HLSL of shader model 6.0, or Metal Shading
// Language 2.1; or by to_wgsl(): WGSL. Names are kept; comments above functions, structures and constants,
// and those behind members, are put back; comments inside functions are lost.
// - A text without a main stays a file of functions. What it declares and the user defines is declared in the
//   result, too; in WGSL, which has no declarations without a body, by a comment. In MSL these functions
//   have a last parameter, a structure GloamImages of the user's images, and so has every function that calls
//   them.
// - A text with a main of this stage is one whole shader. A line at its head names its registers (HLSL) or
//   its indices (MSL). The entry point is main in HLSL and WGSL, NAME_main in MSL: NAME is that of the text,
//   without folder and suffix. WGSL has compute shaders only.
// HLSL has been compiled by glslang. Throws CompileError if the text, or the HLSL, does not compile;
// std::invalid_argument for what cannot be translated.
[[nodiscard]] std::string translated(const Source& packed, Target target, Stage stage = Stage::compute);

}  // namespace gloam::shader
