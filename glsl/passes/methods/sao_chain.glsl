// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SAO_CHAIN_GLSL
#define GLOAM_METHODS_SAO_CHAIN_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "passes/preparation/depth_chain.glsl"

// SAO with its depth chain in an image (preparation/depth_chain.comp), as its authors have it: far taps read neighbouring texels of a small
// image, not pixels that lie far apart. The result is that of sao.glsl to the bit; but where objects move, far taps are no probes of what
// has moved. Reads what sao reads.

float gloam_chain_tap(vec3 position, vec3 normal, ivec2 aimed, ivec2 pixel, GloamCamera camera, GloamKernel kernel, GloamMethod method);
#define GLOAM_TAP gloam_chain_tap
#include "passes/methods/sao.glsl"

// Defined by the user: what the preparation passes have written; here the chain's depths in x.
vec4 gloam_fetch_prepared(ivec2 pixel);

// Contribution of the surface at a tap; of further layers the full image has what is asked for.
// aimed: the tap's pixel. pixel: of the shaded point.
float gloam_chain_tap(vec3 position, vec3 normal, ivec2 aimed, ivec2 pixel, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    ivec2 apart = abs(aimed - pixel);
    int level = gloam_depth_mip_level(float(max(apart.x, apart.y)), method.mip_distance, GLOAM_LAST_TAP_LEVEL);
    if (level == 0) return gloam_tap_at(position, normal, aimed, camera, kernel, method);
    ivec2 texel = gloam_depth_mip_pixel(aimed, camera.size, level);
    ivec2 source = gloam_depth_mip_source(texel, camera.size, level);
    if (GLOAM_LAYERS > 1) return gloam_tap_at(position, normal, source, camera, kernel, method);
    float depth = gloam_fetch_prepared(gloam_chain_texel(texel, level, camera.size)).x;
    if (gloam_is_background(depth)) return 0.0;
    vec3 offset = gloam_camera_position(source, depth, camera) - position;
    return gloam_method_tap_occlusion(offset, normal, -position.z, kernel, method);
}

#endif
