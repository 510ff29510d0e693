// SPDX-License-Identifier: MIT
// What the page shows of a frame, sRGB. Row 0 of the images is the top row.
uniform sampler2D depth_image;    // eye-linear depth; background 0
uniform sampler2D normal_image;   // view-space normal that faces the eye
uniform sampler2D albedo_image;   // colour of the surface, linear
uniform sampler2D occlusion_image;  // of this frame, in x
uniform int height;               // of the images, pixels
uniform int shown;                // 0 lit with occlusion, 1 lit without, 2 the occlusion alone: white is open
uniform vec3 up;                  // of the world, in view space

layout(location = 0) out vec4 color;

// Light of a cool sky that is brighter above, and of a warm sun behind the eye.
vec3 lit(vec3 albedo, vec3 normal, float visibility) {
    float above = 0.5 + 0.5 * dot(normal, up);
    vec3 sky = mix(vec3(0.20, 0.17, 0.16), vec3(0.46, 0.54, 0.66), above);
    vec3 sun = vec3(0.58, 0.46, 0.32) * max(dot(normal, normalize(vec3(-0.6, 0.3, 0.6))), 0.0);
    return albedo * (sky * visibility + sun);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    pixel.y = height - 1 - pixel.y;  // row 0 of the canvas is its bottom row
    if (!(texelFetch(depth_image, pixel, 0).x > 0.0)) {
        color = vec4(shown == 2 ? vec3(1.0) : vec3(0.75, 0.80, 0.86), 1.0);
        return;
    }
    float visibility = shown == 1 ? 1.0 : 1.0 - texelFetch(occlusion_image, pixel, 0).x;
    vec3 linear = lit(texelFetch(albedo_image, pixel, 0).rgb, texelFetch(normal_image, pixel, 0).xyz, visibility);
    color = vec4(shown == 2 ? vec3(visibility) : pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
}
