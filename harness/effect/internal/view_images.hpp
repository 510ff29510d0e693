// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "gpu/image.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The images of a view that the passes read.
struct ViewImages {
    ViewImages(const gpu::Device& device, gpu::Extent size);

    // Uploads a view: depth and its layers, normals, positions in the previous frame. Throws
    // std::invalid_argument if one of them has another size than the images.
    void take(const gpu::Device& device, const scene::GBuffer& view);

    // The same for passes that do not convert what an engine has stored: depth is linear, normals are of view
    // space.
    void take_linear(const gpu::Device& device, const scene::GBuffer& view);

    gpu::Image depth;
    gpu::Image normal;
    std::optional<gpu::Image> stored_depth;   // as the engine stores it, if that is not what the passes read
    std::optional<gpu::Image> stored_normal;  // and its normals, if it has any
    std::optional<gpu::Image> previous_position;
    std::optional<gpu::Image> layers;  // of depth behind the first, one in each channel

  private:
    // Uploads depth and normals, as they are stored if the view has them so.
    void take_surfaces(const gpu::Device& device, const scene::GBuffer& view);
};

}  // namespace gloam::effect
