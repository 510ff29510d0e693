// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SPHERE_PROXY_GLSL
#define GLOAM_METHODS_SPHERE_PROXY_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/falloff.glsl"
#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/proxies.glsl"

// The density of taps is 1 / distance from the pixel, because a piece counts by the inverse square of its distance.
// They are weighted so that their mean is the sum over all pixels of the disc but the shaded one, times the intensity.
// Pieces behind one another all count. The sum is clamped; where many pieces lie behind one another it is too large.

// Balls in the place of pixels (Shanmugam and Arikan 2007; CS-H). Each pixel within the radius is a ball as wide as
// itself, which blocks (r / D)^2 cos. This is exact for one ball above the horizon. Balls behind other balls count
// again, so on a surface seen edge-on the sum grows without bound as pixels get smaller: by 1/4 ln 2 on each halving
// in a groove of 45 degrees.
struct GloamSphereProxy {
    float intensity;  // factor of the sum
};

// pixels around as balls (METHOD-sphere_proxy): `intensity times the sum of 2 rho_i M C(p, s_i), M pixels in the disc`
// [Shanmugam and Arikan 2007, CS-H].
// Error: 2e-6 of each tap's share of the sum, but for taps within rounding of a pixel's border.
GloamEstimate gloam_sphere_proxy(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                 GloamSphereProxy settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 axes = footprint.reach * footprint.size;
    float pixels = GLOAM_PI * axes.x * axes.y;
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 random = gloam_halton_point(kernel.first + i + 1u);
        vec2 tap = gloam_turn_disc(random.y * gloam_circle_point(random.x), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        if (at == footprint.pixel) continue;
        float depth = gloam_fetch_depth(at);
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        bool counts = gloam_tap_sees(depth) && dot(offset, offset) <= kernel.radius * kernel.radius &&
                      dot(offset, n) > kernel.bias;
        if (!counts) continue;
        // Half-axes of the radius there, pixels: so large is a pixel in the world.
        vec2 size = axes * (footprint.orthographic ? 1.0 : -position.z / depth);
        size = kernel.radius / size;
        float piece = gloam_contribution_sphere_cosine(offset, n, 0.5 * gloam_sqrt(size.x * size.y));
        sum += 2.0 * random.y * pixels * piece;
    }
    return gloam_estimate(settings.intensity * sum, float(kernel.count), kernel.count);
}

// Mixture sampling (Song 2010; CS-H): the balls of sphere_proxy, weighted by their solid angle times the cosine and
// by the linear falloff of horizon-based occlusion. Only the directions that horizon-based occlusion uses count
// (above the tangent plane by the bias). Balls behind one another count again.
struct GloamMixture {
    float angle_bias;  // radians above the tangent plane below which nothing blocks
    float intensity;   // factor of the sum
};

// Tangent of the least elevation over the image plane at which something blocks, in the direction of an offset.
// bias: (cos, sin) of the angle bias.
float gloam_mixture_horizon(vec3 offset, vec3 normal, vec2 bias) {
    vec2 direction = offset.xy * inversesqrt(max(dot(offset.xy, offset.xy), GLOAM_LEAST_SQUARE));
    vec2 elevation = gloam_hbao_horizon(normal, direction, bias);
    return elevation.y / max(elevation.x, 1e-6);
}

// pixels around as balls above the biased tangent plane (METHOD-mixture): `intensity times the sum of 2 rho_i M H(v) (1
// - |v| / R) C(p, s_i)` [Song 2010, CS-3.2.8].
// Error: 2e-6 of each tap's share of the sum, but for taps within rounding of a pixel's border.
GloamEstimate gloam_mixture(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMixture settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 axes = footprint.reach * footprint.size;
    float pixels = GLOAM_PI * axes.x * axes.y;
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    vec2 bias = gloam_sincos_turns(gloam_turns(settings.angle_bias));
    float sum = 0.0;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 random = gloam_halton_point(kernel.first + i + 1u);
        vec2 tap = gloam_turn_disc(random.y * gloam_circle_point(random.x), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        if (at == footprint.pixel) continue;
        float depth = gloam_fetch_depth(at);
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        bool counts = gloam_tap_sees(depth) && dot(offset, offset) <= kernel.radius * kernel.radius &&
                      dot(offset, n) > kernel.bias;
        if (!counts) continue;
        // Half-axes of the radius there, pixels: so large is a pixel in the world.
        vec2 size = axes * (footprint.orthographic ? 1.0 : -position.z / depth);
        size = kernel.radius / size;
        float above = gloam_above_horizon(offset, gloam_mixture_horizon(offset, n, bias));
        float weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
        float piece = above * weight * gloam_contribution_sphere(offset, n, 0.5 * gloam_sqrt(size.x * size.y));
        sum += 2.0 * random.y * pixels * piece;
    }
    return gloam_estimate(settings.intensity * sum, float(kernel.count), kernel.count);
}

#endif
