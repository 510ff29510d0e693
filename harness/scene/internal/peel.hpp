// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "scene/mesh.hpp"
#include "scene/pass_library.hpp"

namespace gloam::scene {

// How a mesh is looked at.
struct PeelView {
    gpu::Extent extent;
    glm::mat4 projection;  // view to clip
    bool reversed_z = false;
};

// The depth layers of a mesh in view space, the nearest first, as GBuffer::layers holds further ones: one
// image for each of `count`. Surfaces of one and the same depth are one layer. Throws like
// gpu::Commands::submit().
[[nodiscard]] std::vector<std::vector<float>> peel(const gpu::Device& device, const PassLibrary& passes,
                                                   const Mesh& mesh, const PeelView& view, int count);

}  // namespace gloam::scene
