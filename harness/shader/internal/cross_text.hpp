// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

// Modules as texts of other languages, as SPIRV-Cross writes them; names are kept. All of these throw
// std::runtime_error with SPIRV-Cross's message.
namespace gloam::shader::internal {

// GLSL 4.50 for Vulkan.
[[nodiscard]] std::string to_glsl(const Spirv& module);

// HLSL of shader model 6.0 for Vulkan: push constants have the attribute [[vk::push_constant]], images are
// as in the module.
[[nodiscard]] std::string to_hlsl(const Spirv& module);

// HLSL of shader model 6.0 for Direct3D. The number of a register is that of the binding: b for uniform
// buffers, t for what is only read, u for what is written, s for samplers. Push constants are the constant
// buffer after the last one.
[[nodiscard]] std::string to_direct3d_hlsl(const Spirv& module);

// Metal Shading Language 2.1. The number of a buffer, texture or sampler is that of the binding; push
// constants are the buffer after the last binding. The entry point gets this name.
[[nodiscard]] std::string to_msl(const Spirv& module, const std::string& entry);

}  // namespace gloam::shader::internal
