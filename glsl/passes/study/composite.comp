// SPDX-License-Identifier: MIT
#version 450
// The lit image: ambient light, darkened by occlusion, and direct light, which occlusion does not darken (McGuire, Mara
// and Luebke 2012; ISSAO-2): ambient * (1 - occlusion) + direct. One invocation a pixel.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  rgba32f  light that leaves the surface by ambient light that nothing hides, in xyz, linear
//   1  rgba32f  by direct light, in xyz, its shadows in it, the same unit; the sky at the background
//   2  r32f     occlusion, [0, 1], as it is shown: filtered, remapped
//   3  rgba32f  written: the sum in xyz; w is 1
//   4  rgba32f  diffuse albedo in xyz, linear; read when multi_bounce is set
#include "gloam/shading/ambient.glsl"

#include "passes/study/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT ambient_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT direct_image;
layout(binding = 2 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT occlusion_image;
layout(binding = 3, rgba32f) uniform writeonly highp image2D lit_image;

layout(binding = 4 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT albedo_image;

layout(push_constant) uniform Parameters {
    ivec2 size;         // of the images, pixels
    uint multi_bounce;  // 1: blockers send light, too (Jimenez et al. 2016); 0: they are black
} parameters;

// What arrives of the ambient light.
vec3 arriving(vec3 incident, float occlusion, ivec2 pixel) {
    if (parameters.multi_bounce == 0u) return gloam_ambient_light(incident, occlusion);
    return incident * gloam_multi_bounce(occlusion, GLOAM_FETCH(albedo_image, pixel).xyz);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    vec3 ambient = arriving(GLOAM_FETCH(ambient_image, pixel).xyz, GLOAM_FETCH(occlusion_image, pixel).x, pixel);
    imageStore(lit_image, pixel, vec4(ambient + GLOAM_FETCH(direct_image, pixel).xyz, 1.0));
}
