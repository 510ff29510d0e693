// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/pixel_center.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/occlusion/sphere_proxy.hpp"
#include "reference/sampling/circle.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

struct GloamSphereProxy {
    double intensity;
};

// The sum over the pixels of the disc, each a ball as wide as itself, from taps of density 1 / (2 pi rho): a
// tap stands for 2 rho times the disc's pixels.
inline GloamEstimate gloam_sphere_proxy(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                        const GloamKernel& kernel, const GloamSphereProxy& own,
                                        const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const double pixels = pi * axes.x * camera.size.x * axes.y * camera.size.y;
    double sum = 0.0;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec2 zeta = gloam_halton_2d(kernel.first + i);
        const dvec2 tap = gloam_rotate_disc(zeta.y * gloam_circle_point(zeta.x), kernel.angle);
        const glm::ivec2 pixel = gloam_nearest_pixel(uv + axes * tap, camera.size);
        if (pixel == gloam_nearest_pixel(uv, camera.size)) continue;
        double most = 0.0;
        for (int layer = 0; layer < kernel.layers; ++layer) {
            const double depth = depth_of_layer(fetch_layers(pixel), layer);
            const dvec3 offset = gloam_camera_position(pixel, depth, camera) - position;
            if (gloam_is_background(depth) || length(offset) > kernel.radius) continue;
            if (!(dot(offset, n) > kernel.bias)) continue;
            const dvec2 across =
                kernel.radius / (gloam_camera_radius(kernel.radius, depth, camera) * dvec2(camera.size));
            const double ball = sqrt(across.x * across.y) / 2.0;
            most = max(most, gloam_contribution_sphere_cosine(offset, n, ball));
        }
        sum += 2.0 * zeta.y * pixels * most;
    }
    return gloam_estimate(own.intensity * sum, kernel.count, kernel.count);
}

}  // namespace gloam::reference
