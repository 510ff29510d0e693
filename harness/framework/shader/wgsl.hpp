// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// The module uses what WGSL does not have. what() is one line that names it.
class WgslError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The module uses what WGSL may have, but this translator does not know.
class NotTranslated : public WgslError {
    using WgslError::WgslError;
};

struct WgslOptions {
    // Directions of parameters, which SPIR-V does not keep (functions()). A function that is declared and not
    // defined is written as a comment; the user defines it.
    std::vector<Function> functions;
    // The comment above a function: whole lines, "//" included. May be empty.
    std::function<std::string(const Function& function)> comment_above;
    // The comment of another declaration (block: "") or of a member of a structure or block, likewise.
    std::function<std::string(const std::string& block, const std::string& name)> comment_of;
    // Text at the beginning.
    std::string head;
    // false: only functions and what they use, without main and its resources.
    bool entry_point = true;
};

// The module as a text of WGSL with the same names, structures and functions. The module is best one that
// compile() made in the variant "shipped": other forms are correct, but have fewer names.
//
// - Push constants become a uniform buffer in the first group that has no other resource, at binding 0.
// - Images that are only read become textures, read with textureLoad; those that are written become storage
//   textures. A combined sampler becomes a texture and a sampler, which has the next free binding of the
//   group.
// - Types of 16 bits need the extension f16 of WGSL, subgroup operations the extension subgroups: the text
//   then begins with `enable`.
// - Specialization constants become `override` with the same @id.
// - An out or inout parameter becomes a pointer.
// - Inputs and outputs of a vertex or fragment shader become private variables around a function main_body,
//   which main calls. A vertex shader changes the sign of gl_Position.y, which goes up in WebGPU: the picture
//   is that of Vulkan.
//
// Throws WgslError for what WGSL does not have, NotTranslated for what is not translated, and
// std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] std::string to_wgsl(const Spirv& module, const WgslOptions& options = {});

}  // namespace gloam::shader
