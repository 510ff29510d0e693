// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// Which frame of a scene is drawn, and what else is wanted of each pixel.
struct RasterizeOptions {
    int frame = 0;
    bool motion = false;  // GBuffer::motion and previous_position; in frame 0 nothing has a history
    bool ids = false;     // GBuffer::object and triangle
    bool color = false;   // GBuffer::color, of the triangles; 0 at the background
    int layers = 1;      // of depth, 1 to 1 + most_further_layers: GBuffer::layers has those behind the first
    double guard = 0.0;  // part of the image drawn around it on each side, 0 to 0.5 (guard_band.hpp)
};

// Draws a scene on the device into depth and normals, as an engine would: the value that goes into the depth
// buffer (32-bit float), made linear by the library's own function; interpolated normals, turned to the
// viewer. Vertices are moved to view space in double, so a scene far from the origin is as exact as one near
// it. Layers are peeled, each by a run of its own: the
// nearest surface whose value in the depth buffer is behind that of the layer before, compared exactly.
// Surfaces that coincide to the bit are one layer. From frame 1 on the camera knows that of the frame before.
// With a guard the view is larger than `extent`: GBuffer::border says by how much. Throws std::runtime_error
// for a size of 0 or beyond the device's limit, std::invalid_argument for a negative frame, layers or a guard
// out of range, and a scene that validate() refuses.
[[nodiscard]] GBuffer rasterize(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
                                gpu::Extent extent, const RasterizeOptions& options = {});

}  // namespace gloam::scene
