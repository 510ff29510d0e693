// SPDX-License-Identifier: MIT
// What the page shows of a frame, sRGB. Row 0 of the images is the top row.
uniform sampler2D depth_image;    // eye-linear depth; background 0
uniform sampler2D normal_image;   // view-space normal that faces the eye
uniform sampler2D albedo_image;   // colour of the surface, linear
uniform sampler2D occlusion_image;  // of this frame, in x
uniform sampler2D history_image;  // samples accumulated in y; may be smaller
uniform sampler2D kept_image;     // an earlier occlusion, read where has_kept is set
uniform bool has_kept;
uniform ivec2 size;               // of the images, pixels
uniform int shown;                // 0 lit, 1 visibility, 2 convergence, 3 samples accumulated, 4 normals, 5 difference
uniform float weight_max;         // samples at which a pixel has converged
uniform int split;                // left of this column the kept occlusion is shown, or none, pixels
uniform vec3 up;                  // of the world, in view space

layout(location = 0) out vec4 color;

// Light of a cool sky that is brighter above, and of a warm sun behind the eye.
vec3 lit(vec3 albedo, vec3 normal, float visibility) {
    float above = 0.5 + 0.5 * dot(normal, up);
    vec3 sky = mix(vec3(0.20, 0.17, 0.16), vec3(0.46, 0.54, 0.66), above);
    vec3 sun = vec3(0.58, 0.46, 0.32) * max(dot(normal, normalize(vec3(-0.6, 0.3, 0.6))), 0.0);
    return albedo * (sky * visibility + sun);
}

// From dark blue over green to yellow, for a share in [0, 1].
vec3 heat(float share) {
    vec3 low = vec3(0.05, 0.03, 0.25);
    vec3 middle = vec3(0.05, 0.45, 0.40);
    vec3 high = vec3(0.95, 0.85, 0.25);
    return share < 0.5 ? mix(low, middle, 2.0 * share) : mix(middle, high, 2.0 * share - 1.0);
}

vec3 picture(ivec2 pixel, bool left) {
    float kept = has_kept ? texelFetch(kept_image, pixel, 0).x : 0.0;
    float now = texelFetch(occlusion_image, pixel, 0).x;
    float samples = texelFetch(history_image, pixel * textureSize(history_image, 0) / size, 0).y;
    vec3 normal = texelFetch(normal_image, pixel, 0).xyz;
    float visibility = left ? 1.0 - kept : 1.0 - now;
    if (shown == 1) return vec3(visibility);
    if (shown == 2) return heat(min(samples / weight_max, 1.0));
    if (shown == 3) return heat(min(log2(1.0 + samples) / 10.0, 1.0));
    if (shown == 4) return 0.5 + 0.5 * normal;
    if (shown == 5) return heat(has_kept ? min(8.0 * abs(now - kept), 1.0) : 0.0);
    return lit(texelFetch(albedo_image, pixel, 0).rgb, normal, visibility);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    pixel.y = size.y - 1 - pixel.y;  // row 0 of the canvas is its bottom row
    if (abs(pixel.x - split) < 1 && split > 0 && split < size.x) {
        color = vec4(0.1, 0.45, 0.85, 1.0);
        return;
    }
    if (!(texelFetch(depth_image, pixel, 0).x > 0.0)) {
        color = vec4(shown == 0 ? vec3(0.75, 0.80, 0.86) : vec3(1.0), 1.0);
        return;
    }
    vec3 linear = picture(pixel, pixel.x < split);
    bool encodes = shown == 0;
    color = vec4(encodes ? pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2)) : linear, 1.0);
}
