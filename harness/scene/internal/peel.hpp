// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "scene/mesh.hpp"
#include "scene/pass_library.hpp"

namespace gloam::scene {

// The view of a mesh.
struct PeelView {
    gpu::Extent extent;
    glm::mat4 projection;  // view to clip
    bool reversed_z = false;
};

// The depth layers of a mesh in view space, nearest first, with the values of GBuffer::layers: `count`
// images. Surfaces of exactly equal depth form one layer. Throws like gpu::Commands::submit().
[[nodiscard]] std::vector<std::vector<float>> peel(const gpu::Device& device, const PassLibrary& passes,
                                                   const Mesh& mesh, const PeelView& view, int count);

}  // namespace gloam::scene
