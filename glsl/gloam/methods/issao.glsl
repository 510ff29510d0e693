// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_GLSL
#define GLOAM_METHODS_ISSAO_GLSL

#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/covering_radius.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/layers.glsl"
#include "gloam/sampling/halton_point.glsl"
#include "gloam/sampling/issao_offset.glsl"
#include "gloam/sampling/rotation.glsl"

// ISSAO, the improved screen-space ambient occlusion, reconstructed: surface points under the circle that covers the
// image of a disc across the view ray (ISSAO-P), radii uniform (ISSAO-1, polar reading), each counting phi (v . n -
// psi) / (v . v + sigma) (ISSAO-6). The kernel's bias is psi.
struct GloamIssao {
    float epsilon;    // root of sigma, world units
    float intensity;  // lambda phi as a share of the radius
};

// No circle covers more than this many times the disc parallel to the screen.
const float GLOAM_ISSAO_MOST_STRETCH = 4.0;

// Defined by the user: eye-linear depth of a pixel inside the image, world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the user: depths of the layers behind that, negative where seen from behind, 0 where there is none; read
// where the kernel has more than one layer.
vec3 gloam_fetch_layers(ivec2 pixel);

// All samples of one pixel in one frame.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns the occlusion; outside the image the nearest pixel counts. No samples where there is nothing to gather
// (gloam_can_gather). Error: that of the contributions, but for taps within rounding of a pixel's border.
GloamEstimate gloam_issao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamIssao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos(kernel.angle);
    float parallel = gloam_covering_radius_parallel(position, kernel.radius, 3.402823466e38);
    float covering = gloam_covering_radius_perpendicular(position, kernel.radius, GLOAM_ISSAO_MOST_STRETCH * parallel);
    float stretch = parallel > 0.0 ? covering / parallel : 1.0;
    float phi = settings.intensity * kernel.radius;
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap =
            gloam_turn_disc(gloam_issao_offset_polar(gloam_halton_point(kernel.first + i + 1u).yx, stretch), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        float first = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, first, kernel.farthest)) continue;
        vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);
        float most = 0.0;
        for (int layer = 0; layer < kernel.layers; ++layer) {
            float depth = gloam_layer_depth(first, further, layer);
            vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
            float squared = dot(offset, offset);
            float above = dot(offset, n) - kernel.bias;
            bool counts = gloam_tap_sees(depth) && above > 0.0 && squared < kernel.radius * kernel.radius;
            most = counts ? max(most, phi * (above / (squared + settings.epsilon * settings.epsilon))) : most;
        }
        sum += most;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
