// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/depth_rejection.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/rotation.hpp"
#include "reference/sampling/tangent_frame.hpp"

namespace gloam::reference {

struct GloamHemisphere {
    double range;
};

// The mean over the points p + R s_i of whether the layers block them, each moved along its plane to the
// pixel's centre; a point behind the eye is not taken.
inline GloamEstimate gloam_hemisphere(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                      const GloamKernel& kernel, const GloamHemisphere& own,
                                      const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dmat3 frame = gloam_tangent_frame(normalize(normal));
    double blocked = 0.0;
    unsigned samples = 0U;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec3 s = gloam_hemisphere_cosine(gloam_halton_3d(kernel.first + i));
        const dvec3 point = position + kernel.radius * (frame * gloam_rotate_hemisphere(s, kernel.angle));
        if (s == dvec3(0.0) || gloam_is_background(-point.z)) continue;
        const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(point, camera), camera.size);
        const double depth = gloam_plane_depth(pixel, point, frame[2], camera);
        const dvec4 depths = fetch_layers(pixel);
        if (gloam_tap_rejected(-position.z, depths.x, kernel.farthest)) continue;
        GloamLayersSeen seen{};
        for (int layer = 0; layer < kernel.layers; ++layer)
            seen = gloam_layers_add(
                seen, gloam_sample_blocked(depth, depth_of_layer(depths, layer), kernel.bias, own.range),
                {depths.y, depths.z, depths.w}, depth, layer, kernel.layers);
        blocked += seen.occlusion;
        ++samples;
    }
    return gloam_estimate(blocked, samples, samples);
}

}  // namespace gloam::reference
