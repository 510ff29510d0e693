// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/occlusion/depth_rejection.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/sampling/slice_sample.hpp"
#include "reference/sampling/whole_samples.hpp"

namespace gloam::reference {

// What a tap of a slice sees; tells: a surface, which is neither the pixel's own nor rejected.
struct SliceTap {
    dvec3 offset;
    bool tells;
};

// The estimate of all slices of a kernel. add(slice, n, tap) gives (occluded, whole) of a slice, n the unit
// normal; tap(side, i, layer) is tap i to the side 1 or -1, at the share ((i + jitter) / steps)^2 of the
// radius.
template <class Add>
GloamEstimate gather_slices(dvec3 position, dvec3 normal, const GloamCamera& camera,
                            const GloamKernel& kernel, unsigned steps, const Fetch<dvec4>& fetch_layers,
                            const Add& add) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const unsigned samples = gloam_whole_samples(kernel.count, 2U * steps);
    dvec2 sum(0.0);
    for (unsigned s = 1; s <= samples / (2U * steps); ++s) {
        const GloamSliceSample sample =
            gloam_slice_sample(kernel.first / (2U * steps) + s, gloam_turns(kernel.angle));
        const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
        const auto tap = [&](double side, unsigned i, int layer) {
            const double share = side * pow((i + sample.jitter) / steps, 2);
            const glm::ivec2 pixel = gloam_nearest_pixel(uv + share * axes * sample.direction, camera.size);
            const double depth = depth_of_layer(fetch_layers(pixel), layer);
            const dvec3 point = gloam_camera_position(pixel, depth, camera);
            const bool own_pixel = pixel == gloam_nearest_pixel(uv, camera.size);
            return SliceTap{point - position, !own_pixel && point != dvec3(0.0) &&
                                                  !gloam_tap_rejected(-position.z, depth, kernel.farthest)};
        };
        sum += add(gloam_slice(sample.direction * upright, view, n), n, tap);
    }
    return gloam_estimate(sum.x, sum.y, samples);
}

}  // namespace gloam::reference
