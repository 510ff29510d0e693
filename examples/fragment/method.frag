// SPDX-License-Identifier: MIT
// A whole method, the horizon sweep, in one draw call: a triangle over the whole image, depth and normals in textures.
// Any other method of gloam/methods is called the same way.

// What the engine has. Row 0 of the textures is the image's top row, so P11 is negative; with row 0 at the bottom, as
// OpenGL has it, P11 is positive. Without `highp` OpenGL ES reads samplers with as few bits as it likes.
uniform highp sampler2D engine_depth;   // eye-linear, world units, R32F; background is infinite
uniform highp sampler2D engine_normal;  // view space, unit, towards the eye
uniform vec2 p00_p11;                   // elements [0][0] and [1][1] of the projection
uniform float radius;                   // of influence, world units

layout(location = 0) out vec4 occlusion;

// The method reads depths by this function.
float gloam_fetch_depth(ivec2 pixel) {
    return texelFetch(engine_depth, pixel, 0).x;
}

#include "gloam/methods/sweep.glsl"
#include "gloam/sampling/hash_rotation.glsl"

const uint SLICES = 4u;
const uint STEPS = 4u;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    GloamCamera camera = GloamCamera(p00_p11, textureSize(engine_depth, 0), false);
    vec3 position = gloam_camera_position(pixel, gloam_fetch_depth(pixel), camera);
    vec3 normal = texelFetch(engine_normal, pixel, 0).xyz;
    float bias = 1e-3 * radius;
    float angle = gloam_hash_rotation(pixel);
    uint samples_before = 0u;  // of earlier frames, where a history takes the mean over frames
    uint samples = SLICES * 2u * STEPS;
    GloamKernel kernel = GloamKernel(radius, bias, angle, samples_before, samples, GLOAM_FARTHEST);
    GloamSweep settings = GloamSweep(STEPS, 1.0, GLOAM_FALLOFF_LINEAR);
    occlusion = vec4(gloam_sweep(position, normal, camera, kernel, settings).occlusion);
}
