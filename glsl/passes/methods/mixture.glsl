// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_MIXTURE_GLSL
#define GLOAM_METHODS_MIXTURE_GLSL

#include "gloam/occlusion/falloff.glsl"
#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/proxy_gather.glsl"
#include "gloam/occlusion/sphere_proxy.glsl"

// Mixture sampling (Song 2010; CS-H): the balls of sphere_proxy, by their solid angle times the cosine, restricted to the directions that
// horizon-based occlusion looks at (above the tangent plane by the bias) and weighted by its linear falloff. Stacked balls count again.
// Reads angle_bias and intensity, a factor of the sum.

// Tangent of the elevation over the image plane from which on something blocks, in the direction of an offset.
float gloam_mixture_horizon(vec3 offset, vec3 normal, float bias) {
    vec2 direction = gloam_safe_normalize(vec3(offset.xy, 0.0), vec3(0.0)).xy;
    vec2 elevation = gloam_sincos(min(gloam_tangent_elevation(normal, direction) + bias, 1.570796327));
    return elevation.y / max(elevation.x, 1e-6);
}

float gloam_method_proxy_occlusion(GloamProxy proxy, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    float above = gloam_above_horizon(proxy.offset, gloam_mixture_horizon(proxy.offset, normal, method.angle_bias));
    float weight = gloam_falloff_linear(gloam_length(proxy.offset), kernel.radius);
    float radius = 0.5 * gloam_sqrt(proxy.size.x * proxy.size.y);
    return above * weight * gloam_contribution_sphere(proxy.offset, normal, radius);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_proxy_gather(position, normal, camera, kernel, method);
}

#endif
