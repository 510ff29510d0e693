// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// Draws a scene on the device into depth and normals, as an engine would: the value that goes into the depth
// buffer (32-bit float), made linear by the library's own function; interpolated normals, turned to the
// viewer. Throws std::runtime_error for a size of 0 or beyond the device's limit, std::invalid_argument for a
// scene without triangles, with indices that do not fit its vertices, or with a bad camera.
[[nodiscard]] GBuffer rasterize(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
                                gpu::Extent extent);

}  // namespace gloam::scene
