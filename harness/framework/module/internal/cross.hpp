// SPDX-License-Identifier: MIT
#pragma once

#include <spirv_cross_c.h>
#include <memory>
#include <span>
#include <string>

#include "module/compile.hpp"

namespace gloam::module::internal {

// SPIRV-Cross on one module. Pointers from it are valid as long as this object.
class Cross {
  public:
    // `purpose`, for messages: "write the module as GLSL". Throws std::runtime_error.
    Cross(const Spirv& module, spvc_backend backend, std::string purpose);

    [[nodiscard]] spvc_compiler compiler() const { return compiler_; }

    // Throws std::runtime_error unless the call has succeeded.
    void require(spvc_result result) const;

    [[nodiscard]] std::span<const spvc_reflected_resource> list(spvc_resources resources,
                                                                spvc_resource_type type) const;

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

// HLSL of shader model 6.0 for Direct3D. The number of a register is that of the binding: b for uniform
// buffers, t for what is only read, u for what is written, s for samplers. Push constants are the constant
// buffer after the last one.
[[nodiscard]] std::string to_direct3d_hlsl(const Spirv& module);

// Metal Shading Language 2.1. The number of a buffer, texture or sampler is that of the binding; push
// constants are the buffer after the last binding.
[[nodiscard]] std::string to_msl(const Spirv& module);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

}  // namespace gloam::module::internal
