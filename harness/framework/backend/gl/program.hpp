// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backend/gl/device.hpp"
#include "backend/gl/resources.hpp"

namespace gloam::backend::gl {

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

    // Throws backend::Error.
    Program(const Device& device, Stage stage, const ShaderText& shader);

    [[nodiscard]] std::uint32_t handle() const { return handle_.name(); }

  private:
    Handle handle_;
};

// One run of a compute shader.
struct Dispatch {
    const Program& program;
    std::map<std::uint32_t, std::reference_wrapper<const Buffer>> storage;   // by binding
    std::map<std::uint32_t, std::reference_wrapper<const Buffer>> uniforms;  // by binding
    // By binding, for a storage image and for a sampled image alike.
    std::map<std::uint32_t, std::reference_wrapper<const Image>> images{};
    std::array<std::uint32_t, 3> groups{1, 1, 1};
};

// Runs it and waits for its end. Runs that follow see what this one has written. Throws backend::OutOfMemory,
// backend::Error.
void dispatch(const Device& device, const Dispatch& work);

// One run of a fragment shader over all pixels of its targets. Targets have four unsigned channels of 32 bits
// (RGBA32UI); target i is the shader's output at location i.
struct Draw {
    const Program& program;
    // The shader's usampler2D of that name; one that it does not use is passed over.
    std::vector<std::pair<std::string, const WordTexture*>> textures;
    // The shader's uint of that name.
    std::vector<std::pair<std::string, Word>> uniforms;
    std::size_t width = 1;
    std::size_t height = 1;
    std::size_t targets = 1;  // at most four
};

// Runs it and waits for its end. Returns the words of each target: width x height x 4, the bottom row first.
// Throws backend::Error.
[[nodiscard]] std::vector<std::vector<Word>> draw(const Device& device, const Draw& work);

}  // namespace gloam::backend::gl
