// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/sampling/eye_march.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/poisson.hpp"
#include "reference/sampling/poisson_disc.hpp"
#include "reference/sampling/rotation.hpp"
#include "reference/sampling/tangent_frame.hpp"
#include "reference/sampling/whole_samples.hpp"

namespace gloam::reference {

struct GloamPoisson {
    double range;
    unsigned steps;
};

// The share of the rays of which a layer blocks a step. Each round through the disc is turned by another
// angle.
inline GloamEstimate gloam_poisson(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                   const GloamKernel& kernel, const GloamPoisson& own,
                                   const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dmat3 frame = gloam_tangent_frame(normalize(normal));
    const int steps = std::max(static_cast<int>(own.steps), 1);
    const auto blocked = [&](dvec3 point) {
        const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(point, camera), camera.size);
        if (gloam_is_background(-point.z)) return false;
        if (pixel == gloam_nearest_pixel(gloam_camera_uv(position, camera), camera.size)) return false;
        const double depth = gloam_plane_depth(pixel, point, frame[2], camera);
        const dvec4 seen = fetch_layers(pixel);
        bool any = false;
        for (int layer = 0; layer < kernel.layers; ++layer)
            any =
                any || gloam_sample_blocked(depth, depth_of_layer(seen, layer), kernel.bias, own.range) > 0.0;
        return any;
    };
    const unsigned samples = gloam_whole_samples(kernel.count, steps);
    const unsigned rays = samples / steps;
    unsigned ended = 0U;
    for (unsigned r = 0; r < rays; ++r) {
        const unsigned i = kernel.first / steps + r;
        const double turn = kernel.angle + 2.0 * pi * gloam_radical_inverse(i / 64U, 2U);
        const dvec3 ray = frame * gloam_hemisphere_lift(gloam_rotate_disc(gloam_poisson_disc(i), turn));
        const double jitter =
            fract(gloam_halton_3d(i + 1U).y + gloam_unit_interval(kernel.angle / (2.0 * pi)));
        bool any = false;
        for (int k = 0; k < steps; ++k)
            any = any || blocked(gloam_eye_march(position, ray, kernel.radius, k, steps, jitter));
        ended += any ? 1U : 0U;
    }
    return gloam_estimate(ended, rays, samples);
}

}  // namespace gloam::reference
