// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gbuffer.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// The frame of a scene, and the optional images.
struct DrawOptions {
    int frame = 0;
    bool motion = false;  // GBuffer::motion and previous_position; frame 0 has no history
    bool color = false;   // GBuffer::color, of the triangles; 0 at the background
    int layers = 1;  // depth layers, 1 to 1 + most_further_layers: GBuffer::layers has those behind the first
    double guard = 0.0;  // share of the image rendered around it on each side, 0 to 0.5 (gbuffer.hpp)
};

// The depth and normals of a scene as an engine would render them: one ray through the centre of each pixel,
// from the near to the far plane. Each point is calculated in double, on its triangle's plane. Normals are
// interpolated and turned to the viewer. Vertices are moved to view space in double, so a scene far from the
// origin is as exact as one near it. Bit-identical for any number of processors.
// Surfaces that touch, as a box and the ground that it stands on, are one layer: which of them a ray meets
// first hangs on last bits. It is seen from behind if all of them are: where one of two solids ends and the
// other begins, there is solid still. From frame 1 on the camera holds the previous frame's view.
// With a guard the view is larger than `extent`; GBuffer::border is the difference on each side.
[[nodiscard]] GBuffer draw(const Scene& scene, backend::Extent extent, const DrawOptions& options = {});

}  // namespace gloam::scene
