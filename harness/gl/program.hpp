// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "gl/device.hpp"

namespace gloam::gl {

// Text of a shader, its #version line first, with the name that messages give it.
struct ShaderText {
    std::string name;
    std::string text;
};

// A program of one shader: a compute shader, or a fragment shader behind a vertex shader of this room that
// covers the whole target with one triangle.
class Program {
  public:
    enum class Stage { compute, fragment };

    // Throws CompileFailed, LinkFailed.
    Program(const Device& device, Stage stage, const ShaderText& shader);
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&&) = delete;

    [[nodiscard]] std::uint32_t handle() const { return handle_; }

  private:
    const Device* device_;
    std::uint32_t handle_ = 0;
};

}  // namespace gloam::gl
