// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_ROTATION_GLSL
#define GLOAM_SAMPLING_ROTATION_GLSL

// Angle with its whole turns taken off, so that sin and cos are asked only where Vulkan bounds their error.
// angle: radians, |angle| <= 65536; anything else, NaN included, gives 0.
// Returns the angle modulo 2 pi, in [-pi, pi]; at odd multiples of pi either end may come.
// Error: 6e-7.
float gloam_wrap_angle(float angle) {
    if (!(abs(angle) <= 65536.0)) return 0.0;
    float turns = floor(angle * 0.159154943 + 0.5);
    // 2 pi in three parts: the products with the first two are exact, so nothing is lost in the subtractions.
    float rest = ((angle - turns * 6.28125) - turns * 0.001934051513671875) - turns * 1.255665915e-6;
    // The number of turns may be off by one where it was rounded.
    rest = rest > 3.141592503 ? rest - 6.283185307 : (rest < -3.141592503 ? rest + 6.283185307 : rest);
    return clamp(rest, -3.141592503, 3.141592503);
}

// Disc sample rotated about the centre (TSSAO-ROT).
// s: point of the unit disc (any vector of length below 1e19).
// angle: radians, counter-clockwise, |angle| <= 65536; anything else, NaN included, rotates by 0.
// Returns s rotated, of the same length; the zero vector for a longer, infinite or NaN s.
// Error: 8 ulp of the largest component beside that of the device's sin and cos (see gloam_circle_point).
vec2 gloam_rotate_disc(vec2 s, float angle) {
    if (!(dot(s, s) <= 1e38)) return vec2(0.0);
    float wrapped = gloam_wrap_angle(angle);
    float c = cos(wrapped);
    float d = sin(wrapped);
    return vec2(c * s.x - d * s.y, d * s.x + c * s.y);
}

// Hemisphere sample rotated about the normal (TSSAO-ROT).
// s: point of the unit half ball in tangent space, z along the normal (any vector of length below 1e19).
// angle: radians, counter-clockwise seen from the tip of the normal, |angle| <= 65536; anything else rotates by 0.
// Returns s rotated: same length, same angle to the normal; the zero vector for a longer, infinite or NaN s.
// Error: 8 ulp of the largest component beside that of the device's sin and cos (see gloam_circle_point).
vec3 gloam_rotate_hemisphere(vec3 s, float angle) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    return vec3(gloam_rotate_disc(s.xy, angle), s.z);
}

#endif
