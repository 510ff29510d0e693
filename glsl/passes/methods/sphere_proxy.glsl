// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SPHERE_PROXY_GLSL
#define GLOAM_METHODS_SPHERE_PROXY_GLSL

#include "gloam/occlusion/proxy_gather.glsl"
#include "gloam/occlusion/sphere_proxy.glsl"

// Balls in the place of pixels (Shanmugam and Arikan 2007; CS-H): each pixel within the radius is a ball as wide as itself, which blocks
// (r / D)^2 cos, exactly for one ball above the horizon. What lies behind other balls counts again: on a surface seen edge-on the sum grows
// without bound as pixels shrink, by 1/4 ln 2 on each halving in a groove of 45 degrees.
// Reads intensity, a factor of the sum.

float gloam_method_proxy_occlusion(GloamProxy proxy, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    float radius = 0.5 * gloam_sqrt(proxy.size.x * proxy.size.y);
    return gloam_contribution_sphere_cosine(proxy.offset, normal, radius);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_proxy_gather(position, normal, camera, kernel, method);
}

#endif
