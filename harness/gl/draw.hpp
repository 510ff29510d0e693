// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "gl/program.hpp"
#include "gl/word_texture.hpp"

namespace gloam::gl {

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
    std::size_t targets = 1;  // at most DeviceInfo::max_draw_buffers, of which every version has four
};

// Runs it and waits for its end. Returns the words of each target: width x height x 4, the bottom row first.
// Throws OutOfMemory, CallFailed.
[[nodiscard]] std::vector<std::vector<Word>> draw(const Device& device, const Draw& work);

}  // namespace gloam::gl
