// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_PROXY_GLSL
#define GLOAM_METHODS_DISC_PROXY_GLSL

#include "gloam/occlusion/disc_proxy.glsl"
#include "gloam/occlusion/proxy_gather.glsl"

// Discs in the place of pixels (Bunnell, GPU Gems 2, on what the eye sees; CS-S): each pixel within the radius is a disc of the surface's area
// there and its normal, which blocks A / (A + pi D^2) times both cosines: the exact cosine-weighted occlusion up to the radius, of surfaces
// that do not hide one another. A surface through the point itself is seen edge-on from there and blocks nothing: a groove is open along its
// line. Of further layers nobody knows the normals: they do not count.
// Reads intensity, a factor of the sum.

// Defined by the user: view-space normal facing the eye of a pixel inside the image, any length.
vec3 gloam_fetch_normal(ivec2 pixel);

// Surfaces seen at less than this cosine count as seen at it: a pixel across their outline would stand for more than is there.
const float GLOAM_DISC_LEAST_FACING = 0.05;

// Area of the surface within a pixel, world units squared.
float gloam_disc_area(GloamProxy proxy, vec3 surface_normal, GloamCamera camera) {
    vec3 ray = camera.orthographic ? vec3(0.0, 0.0, -1.0) : gloam_camera_position(proxy.pixel, 1.0, camera);
    return proxy.size.x * proxy.size.y / max(-dot(surface_normal, ray), GLOAM_DISC_LEAST_FACING);
}

float gloam_method_proxy_occlusion(GloamProxy proxy, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (proxy.layer > 0) return 0.0;
    vec3 emitter = gloam_safe_normalize(gloam_fetch_normal(proxy.pixel), vec3(0.0));
    float area = gloam_disc_area(proxy, emitter, camera);
    return gloam_contribution_disc_proxy_cosine(proxy.offset, normal, emitter, area, 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_proxy_gather(position, normal, camera, kernel, method);
}

#endif
