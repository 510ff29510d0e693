// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "gl/buffer.hpp"
#include "gl/image.hpp"
#include "gl/program.hpp"

namespace gloam::gl {

// One run of a compute shader.
struct Dispatch {
    const Program& program;
    // Storage buffer i has the binding i.
    std::vector<std::reference_wrapper<const Buffer>> storage;
    // A uniform buffer, and its binding.
    const Buffer& uniforms;
    std::uint32_t uniform_binding = 0;
    std::uint32_t groups = 1;  // work groups, in one row
};

// Runs it and waits for its end. Throws OutOfMemory, CallFailed.
void dispatch(const Device& device, const Dispatch& work);

// A pass over images.
struct ImageDispatch {
    const Program& program;
    // By binding, for a storage image and for a sampled image alike.
    std::map<std::uint32_t, std::reference_wrapper<const Image>> images;
    std::map<std::uint32_t, std::reference_wrapper<const Buffer>> storage;   // by binding
    std::map<std::uint32_t, std::reference_wrapper<const Buffer>> uniforms;  // by binding
    std::array<std::uint32_t, 3> groups{1, 1, 1};
};

// The same. Passes that follow see what this one has written.
void dispatch(const Device& device, const ImageDispatch& work);

}  // namespace gloam::gl
