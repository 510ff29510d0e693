// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/pixel_center.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/sampling/slice_sample.hpp"
#include "reference/sampling/whole_samples.hpp"

namespace gloam::reference {

struct GloamGtao {
    unsigned steps;
};

// Slice by slice the highest horizon on either side, of the surface points at the shares ((i + jitter) /
// steps)^2 of the radius.
inline GloamEstimate gloam_gtao(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                const GloamKernel& kernel, const GloamGtao& own,
                                const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const unsigned steps = std::max(own.steps, 1U);
    const unsigned samples = gloam_whole_samples(kernel.count, 2U * steps);
    dvec2 sum(0.0);
    for (unsigned s = 1; s <= samples / (2U * steps); ++s) {
        const GloamSliceSample sample =
            gloam_slice_sample(kernel.first / (2U * steps) + s, gloam_kernel_turns(kernel.angle));
        const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
        const GloamSlice slice = gloam_slice(sample.direction * upright, view, n);
        const auto horizon = [&](double side) {
            double highest = -1.0;
            for (unsigned i = 0; i < steps; ++i) {
                const double share = side * pow((i + sample.jitter) / steps, 2);
                const glm::ivec2 pixel =
                    gloam_nearest_pixel(uv + share * axes * sample.direction, camera.size);
                const dvec3 point = gloam_camera_position(pixel, fetch_depth(pixel), camera);
                const bool own_pixel = pixel == gloam_nearest_pixel(uv, camera.size);
                if (own_pixel || point == dvec3(0.0) || !(dot(point - position, n) > kernel.bias)) continue;
                const dvec3 offset = gloam_into_slice(point - position, cross(slice.tangent, slice.view), n);
                const double weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
                highest = gloam_gtao_horizon(highest, -side * slice.normal.y, offset, slice.view, weight);
            }
            return highest;
        };
        sum = gloam_gtao_add(sum, slice, {horizon(-1.0), horizon(1.0)});
    }
    return gloam_estimate(sum.x, sum.y, samples);
}

}  // namespace gloam::reference
