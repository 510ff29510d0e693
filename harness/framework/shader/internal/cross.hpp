// SPDX-License-Identifier: MIT
#pragma once

#include <spirv_cross_c.h>
#include <memory>
#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// SPIRV-Cross on one module. Pointers from it are valid as long as this object.
class Cross {
  public:
    // `purpose`, for messages: "write the module as GLSL". Throws std::runtime_error.
    Cross(const Spirv& module, spvc_backend backend, std::string purpose);

    [[nodiscard]] spvc_compiler compiler() const { return compiler_; }

    // Throws std::runtime_error unless the call has succeeded.
    void require(spvc_result result) const;

  private:
    struct Destroy {
        void operator()(spvc_context context) const { spvc_context_destroy(context); }
    };
    std::string purpose_;
    std::unique_ptr<spvc_context_s, Destroy> context_;
    spvc_compiler compiler_ = nullptr;
};

// Modules as texts of other languages, as SPIRV-Cross writes them; names are kept. All of these throw
// std::runtime_error with SPIRV-Cross's message.

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
// constants are the buffer after the last binding.
[[nodiscard]] std::string to_msl(const Spirv& module);

// The module translated to GLSL, or to HLSL, and compiled again. Float controls, which SPIRV-Cross drops, are
// added again. `name`: for messages. Throws CompileError if SPIRV-Cross cannot translate the module or
// glslang rejects the result.
[[nodiscard]] Spirv translated_back(const Spirv& module, Stage stage, const std::string& name, bool hlsl);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

// `module` with those float controls of `original` that it lacks: execution modes such as
// SignedZeroInfNanPreserve, with their capabilities and the extension. Both have one entry point. Throws
// std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] Spirv with_float_controls_of(const Spirv& original, const Spirv& module);

// The module with its storage buffers as SPIR-V has them from version 1.3 on: blocks of the storage class
// StorageBuffer. glslang's HLSL front end makes them BufferBlocks of the class Uniform. Throws
// std::runtime_error for a module that has uniform buffers too: their pointers are of the same class.
[[nodiscard]] Spirv with_storage_buffers(Spirv module);

}  // namespace gloam::shader::internal
