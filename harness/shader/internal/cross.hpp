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

}  // namespace gloam::shader::internal
