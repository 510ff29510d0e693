// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "backend/vulkan/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// The frame of a scene, and the optional images.
struct RasterizeOptions {
    int frame = 0;
    bool motion = false;  // GBuffer::motion and previous_position; frame 0 has no history
    bool ids = false;     // GBuffer::object and triangle
    bool color = false;   // GBuffer::color, of the triangles; 0 at the background
    int layers = 1;  // depth layers, 1 to 1 + most_further_layers: GBuffer::layers has those behind the first
    double guard = 0.0;  // share of the image rendered around it on each side, 0 to 0.5 (guard_band.hpp)
};

// Renders a scene on the device to depth and normals, as an engine would. The depth comes from the value in
// the depth buffer (32-bit float), made linear by the library's own function. Normals are interpolated and
// turned to the viewer. Vertices are moved to view space in double, so a scene far from the origin is as
// exact as one near it.
// Layers are peeled, each in a run of its own: the nearest surface whose depth-buffer value is behind that of
// the layer before, compared exactly. Surfaces of exactly equal depth form one layer. From frame 1 on the
// camera holds the previous frame's view. With a guard the view is larger than `extent`; GBuffer::border is
// the difference on each side.
// Throws std::runtime_error for a size of 0 or beyond the device's limit, std::invalid_argument for a
// negative frame, layers or a guard out of range, and a scene that validate() rejects.
[[nodiscard]] GBuffer rasterize(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
                                gpu::Extent extent, const RasterizeOptions& options = {});

// For each triangle of a mesh in view space, whether it cannot be seen because it is the far side of a closed
// part. A part is what is connected by common positions. It is closed if each of its edges belongs to two
// triangles or more, at least 99 % of the edges are passed in both directions, and the triangles face
// outward. No triangle of a part is hidden while the eye, the origin, is within the bounds of the part.
[[nodiscard]] std::vector<bool> hidden_far_sides(const Mesh& view_space, bool orthographic);

}  // namespace gloam::scene
