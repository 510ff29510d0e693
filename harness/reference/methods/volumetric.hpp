// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/height_at.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/layers.hpp"
#include "reference/occlusion/volumetric.hpp"
#include "reference/sampling/halton_disc.hpp"
#include "reference/sampling/whole_samples.hpp"

namespace gloam::reference {

// The solid share of the chords at pairs of opposite taps, weighted by the chords. The surface of a tap is
// moved along its plane to the aimed place; background lies far behind. Of the layers, first at one tap and
// then at the other, those stay with which the pair is more solid.
inline GloamEstimate gloam_volumetric(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                      const GloamKernel& kernel, const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const auto pixel_of = [&](dvec2 tap) {
        return gloam_nearest_pixel(gloam_camera_uv(position, camera) + axes * tap, camera.size);
    };
    const auto ratio = [&](dvec2 tap, double seen) {
        const double depth = gloam_is_background(seen) ? 1e4 * kernel.radius - position.z : seen;
        const dvec3 aim(kernel.radius * tap * dvec2(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0), 0.0);
        const double height =
            gloam_height_at(gloam_camera_position(pixel_of(tap), depth, camera) - position, aim, view, n);
        return gloam_line_ratio(height, gloam_chord_half_height(tap, kernel.radius));
    };
    double solid = 0.0;
    double whole = 0.0;
    for (unsigned i = 0; i < kernel.count; i += 2U) {
        const dvec2 tap = gloam_halton_disc((kernel.first + i) / 2U + 1U, gloam_sincos(kernel.angle));
        const auto share = [&](dvec2 depths) {
            const dvec2 pair = gloam_line_pair({ratio(tap, depths.x), ratio(-tap, depths.y)}, 0.35, 1.0);
            return pair.x + pair.y;
        };
        dvec2 kept(fetch_layers(pixel_of(tap)).x, fetch_layers(pixel_of(-tap)).x);
        for (const int end : {0, 1}) {
            for (int layer = 1; layer < kernel.layers; ++layer) {
                dvec2 other = kept;
                other[end] = depth_of_layer(fetch_layers(pixel_of(end == 0 ? tap : -tap)), layer);
                if (gloam_tap_sees(other[end]) && share(other) >= share(kept)) kept = other;
            }
        }
        solid += gloam_chord_half_height(tap, kernel.radius) * share(kept);
        whole += gloam_chord_half_height(tap, kernel.radius) * 2.0;
    }
    return gloam_estimate(solid, whole, gloam_paired_samples(kernel.count));
}

}  // namespace gloam::reference
