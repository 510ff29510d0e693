// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "gl/buffer.hpp"
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

}  // namespace gloam::gl
