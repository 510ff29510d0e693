// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SSDO_GLSL
#define GLOAM_METHODS_SSDO_GLSL

#include "gloam/gather/further_depths.glsl"
#include "gloam/gather/method.glsl"
#include "gloam/occlusion/layers.glsl"

// The direct part of directional occlusion (Ritschel, Grosch and Seidel 2009; CS-D) under light of 1 from everywhere:
// the light that does not arrive. Each direction has one point at a uniform distance. Directions are uniform and
// count 2 w . n. The result is the cosine-weighted occlusion with the linear falloff, for a scene that is solid
// behind every visible surface. With more than 1 step, the nearest blocker of that many points counts, and the
// falloff becomes weaker with every step. Where everything is blocked, 2 w . n is 1 only in the mean.
struct GloamSsdo {
    float range;  // world units, about the radius, or infinity: blockers further in front than this are other objects
    uint steps;   // of a ray, at least 1
    int layers;   // of depth that the steps see, 1 to 4
};

// light from everywhere that does not arrive (METHOD-ssdo): `mean of 2 cos(w, n) over blocked rays` [Ritschel, Grosch
// and Seidel 2009, CS-D].
// All samples of one pixel in one frame, by rays.
GloamEstimate gloam_ssdo(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamSsdo settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    mat3 frame = gloam_tangent_frame(normalize(normal));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    uint steps = max(settings.steps, 1u);
    uint rays = gloam_whole_samples(kernel.count, steps) / steps;
    float occluded = 0.0;
    for (uint i = 0u; i < rays; ++i) {
        uint index = kernel.first / steps + i;
        vec3 random = gloam_halton_point(index + 1u);
        // The map's radius is its second coordinate: 1 for a direction.
        vec3 direction =
            frame * gloam_rotate_hemisphere(gloam_hemisphere_uniform(vec3(random.x, 1.0, random.z)), kernel.angle);
        float jitter = random.y;
        bool blocked = false;
        for (uint k = 0u; k < steps && !blocked; ++k) {
            vec3 at = gloam_eye_march(position, direction, kernel.radius, k, steps, jitter);
            ivec2 pixel = gloam_footprint_seen(footprint, at);
            float first = gloam_fetch_depth(pixel);
            vec3 further = gloam_further_depths(pixel, settings.layers);
            if (!(at.z < 0.0) || pixel == footprint.pixel) continue;
            for (int layer = 0; layer < settings.layers; ++layer) {
                float depth = gloam_layer_depth(first, further, layer);
                blocked = blocked || gloam_sample_blocked(gloam_footprint_plane_depth(footprint, pixel, at, frame[2]),
                                                          depth, kernel.bias, settings.range);
            }
        }
        occluded += blocked ? 2.0 * max(dot(direction, frame[2]), 0.0) : 0.0;
    }
    return gloam_estimate(occluded, float(rays), rays * steps);
}

#endif
