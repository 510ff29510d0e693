// SPDX-License-Identifier: MIT
#version 450
// The lit image: ambient light, darkened by occlusion, and direct light, which occlusion does not darken (McGuire, Mara
// and Luebke 2012; ISSAO-2): ambient * (1 - occlusion) + direct.
#include "gloam/shading/ambient.glsl"

#include "passes/study/input_image.glsl"

// Light that leaves the surface, linear: by ambient light that nothing hides; by direct light, its shadows in it, the
// same unit, with the sky at the background.
layout(binding = 0 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT ambient_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT direct_image;
layout(binding = 2 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT occlusion_image;  // as it is shown: filtered, remapped
layout(binding = 3, rgba32f) uniform writeonly highp image2D lit_image;  // the sum in xyz; w is 1
layout(binding = 4 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT albedo_image;  // read when multi_bounce is set

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
