// SPDX-License-Identifier: MIT
#version 450
// Ground-truth ambient occlusion (Jimenez et al. 2016) as one plain loop, as an engine without this library has it. For
// comparison only: `gloam bench front` times presets beside it. Do not copy it: it tests no input, takes single frames
// of perspective cameras only, and promises no accuracy.
//
// A tap's horizon moves towards the tangent plane with its distance, linearly over the radius. Each pixel turns its
// slices and shifts its taps by noise.
#include "passes/study/input_image.glsl"

layout(constant_id = 0) const int slices = 9;
layout(constant_id = 1) const int steps = 3;  // taps on each side of a slice

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;   // background +infinity
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;  // unit
layout(binding = 2, r32f) uniform writeonly highp image2D occlusion_image;

layout(push_constant) uniform Parameters {
    vec2 p00_p11;  // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;    // of the images, pixels
    float radius;  // of influence, world units
} parameters;

const float pi = 3.14159265;
const float far = 1e9;  // background is there, world units

// Abramowitz and Stegun 4.4.45: within 7e-5 radians.
float short_acos(float x) {
    float y = abs(x);
    float angle = sqrt(max(1.0 - y, 0.0)) * (1.5707288 + y * (-0.2121144 + y * (0.0742610 - 0.0187293 * y)));
    return x < 0.0 ? pi - angle : angle;
}

float depth_at(ivec2 pixel) {
    return min(GLOAM_FETCH(depth_image, pixel).x, far);
}

vec3 position_at(ivec2 pixel, float depth) {
    vec2 ndc = (2.0 * vec2(pixel) + 1.0) / vec2(parameters.size) - 1.0;
    return vec3(ndc / parameters.p00_p11 * depth, -depth);
}

// Visibility of the directions from the view vector to a horizon, weighted by the cosine to the normal.
// horizon, n: angles of the horizon and of the normal from the view vector, radians.
float side_visibility(float horizon, float n, float cos_n, float sin_n) {
    return 0.25 * (cos_n - cos(2.0 * horizon - n) + 2.0 * horizon * sin_n);
}

// Interleaved gradient noise (Jimenez 2014).
float noise_at(ivec2 pixel) {
    return fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, parameters.size))) return;
    float depth = depth_at(pixel);
    float reach = 0.5 * parameters.radius * abs(parameters.p00_p11.y) * float(parameters.size.y) / depth;  // pixels
    if (reach < 1.0) {
        imageStore(occlusion_image, pixel, vec4(0.0));
        return;
    }
    vec3 position = position_at(pixel, depth);
    vec3 normal = GLOAM_FETCH(normal_image, pixel).xyz;
    vec3 view = normalize(-position);
    float turn = noise_at(pixel);
    float shift = fract(dot(vec2(pixel), vec2(0.75487767, 0.56984029)));
    float visibility = 0.0;
    for (int i = 0; i < slices; ++i) {
        float phi = (float(i) + turn) * pi / float(slices);
        vec2 direction = vec2(cos(phi), sin(phi));  // y down
        vec3 along = vec3(direction.x, -direction.y, 0.0);
        vec3 tangent = normalize(along - dot(along, view) * view);
        float normal_x = dot(normal, tangent);
        float normal_y = dot(normal, view);
        float weight = sqrt(normal_x * normal_x + normal_y * normal_y) + 1e-6;
        float sin_n = normal_x / weight;
        float cos_n = clamp(normal_y / weight, 0.0, 1.0);
        float n = sign(sin_n) * short_acos(cos_n);
        for (float side = -1.0; side <= 1.0; side += 2.0) {
            float lowest = -side * sin_n;
            float horizon = lowest;
            for (int k = 0; k < steps; ++k) {
                float share = (float(k) + shift) / float(steps);
                vec2 offset = side * max(share * share * reach, 1.0) * direction;
                ivec2 at = clamp(pixel + ivec2(round(offset)), ivec2(0), parameters.size - 1);
                vec3 seen = position_at(at, depth_at(at)) - position;
                float inverse = inversesqrt(dot(seen, seen));
                float falloff = clamp(1.0 - 1.0 / (inverse * parameters.radius), 0.0, 1.0);
                horizon = max(horizon, mix(lowest, dot(seen, view) * inverse, falloff));
            }
            visibility += weight * side_visibility(short_acos(horizon), side * n, cos_n, side * sin_n);
        }
    }
    imageStore(occlusion_image, pixel, vec4(clamp(1.0 - visibility / float(slices), 0.0, 1.0)));
}
