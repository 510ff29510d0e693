// SPDX-License-Identifier: MIT
// Alchemy ambient occlusion in one draw call, as an OpenGL 3.3 or OpenGL ES 3.0 engine has it: a triangle over the
// whole image, the depth in a texture.

// What the engine has. The projection's y is up, as OpenGL's rows are. Without `highp` OpenGL ES reads samplers with
// as few bits as it likes.
uniform highp sampler2D engine_depth;  // eye-linear, world units, R32F
uniform vec2 p00_p11;                  // elements [0][0] and [1][1] of the projection
uniform float radius;                  // of influence, world units

layout(location = 0) out vec4 visibility;

// The library asks for the depth by this function.
float gloam_fetch_depth(ivec2 pixel) {
    return texelFetch(engine_depth, pixel, 0).x;
}

#include "gloam/geometry/camera_normal.glsl"
#include "gloam/occlusion/alchemy.glsl"

const int TAPS = 12;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(engine_depth, 0);
    GloamCamera camera = GloamCamera(p00_p11, size, false);
    vec3 position = gloam_camera_surface(pixel, camera);
    vec3 normal = gloam_camera_normal(pixel, camera);
    vec2 reach = 0.5 * radius * p00_p11 / -position.z * vec2(size);  // pixels
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float occlusion = 0.0;
    for (int i = 0; i < TAPS; ++i) {
        float share = (float(i) + 0.5) / float(TAPS);
        float angle = turn + 2.3999632 * float(i);  // a spiral by the golden angle
        ivec2 tap = clamp(pixel + ivec2(round(reach * sqrt(share) * vec2(cos(angle), sin(angle)))), ivec2(0), size - 1);
        vec3 offset = gloam_camera_surface(tap, camera) - position;
        // The last argument is twice the distance of the strongest influence.
        occlusion += gloam_contribution_alchemy(offset, normal, 0.005 * radius, 1e-7, 0.8 * radius) / float(TAPS);
    }
    visibility = vec4(vec3(clamp(1.0 - occlusion, 0.0, 1.0)), 1.0);
}
