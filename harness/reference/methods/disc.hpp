// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/pixel_center.hpp"
#include "reference/occlusion/depth_rejection.hpp"
#include "reference/occlusion/fox_compton.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/sampling/halton_disc.hpp"

namespace gloam::reference {

struct GloamDisc {
    double epsilon;
};

// The mean of epsilon C(p, s_i) over the surface points s_i under the taps, of the layer for which it is
// largest; one beyond the radius, or no higher than the bias above the tangent plane, contributes nothing.
inline GloamEstimate gloam_disc(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                const GloamKernel& kernel, const GloamDisc& own,
                                const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    double sum = 0.0;
    unsigned samples = 0U;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec2 tap = gloam_halton_disc(kernel.first + i, gloam_sincos(kernel.angle));
        const glm::ivec2 pixel =
            gloam_nearest_pixel(gloam_camera_uv(position, camera) + axes * tap, camera.size);
        const dvec4 depths = fetch_layers(pixel);
        if (gloam_tap_rejected(-position.z, depths.x, kernel.farthest)) continue;
        ++samples;
        double most = 0.0;
        for (int layer = 0; layer < kernel.layers; ++layer) {
            const dvec3 point = gloam_camera_position(pixel, depth_of_layer(depths, layer), camera);
            if (point == dvec3(0.0) || distance(point, position) > kernel.radius) continue;
            if (dot(point - position, n) > kernel.bias)
                most = max(most, gloam_contribution_fox_compton_scaled(position, n, point, own.epsilon));
        }
        sum += most;
    }
    return gloam_estimate(sum, samples, samples);
}

}  // namespace gloam::reference
