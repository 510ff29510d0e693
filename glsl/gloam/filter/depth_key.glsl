// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_DEPTH_KEY_GLSL
#define GLOAM_FILTER_DEPTH_KEY_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// The depth that a blur stores beside the occlusion, in two of the four 8-bit channels (SAO).

// depth as a key for a blur (CS-Q-key): `clamp(d / z_key, 0, 1)` [McGuire, Mara and Luebke 2012 (Scalable Ambient
// Obscurance)].
// depth: d, eye-linear, world units. z_key: depth of the key 1, world units, in [2^-126, 2^126]; SAO uses 300 m.
// Returns a key in [0, 1]; 1 for background, for a depth from z_key on, and for a z_key outside its range.
// Error: 1.5 ULP; 3.5 by any device that keeps Vulkan's rules.
// No method or pass here calls it: it is there to be copied.
float gloam_depth_key(float depth, float z_key) {
    bool divides = z_key >= GLOAM_SMALLEST && z_key <= GLOAM_LARGEST_DIVISOR;
    return !gloam_is_background(depth) && divides && depth < z_key ? min(depth / z_key, 1.0) : 1.0;
}

// key as two bytes (CS-Q-pack): `k = round(65535 key); (k >> 8, k & 255) / 255` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance), made exact].
// Key as two bytes, each stored exactly by an 8-bit channel: the high and the low byte of round(65535 key), over 255.
// (SAO prints floor(256 key) / 256 for the first, which such a channel rounds to another byte from 128 on.)
// key: in [0, 1]; outside, the nearer end; 0 for NaN.
// Returns (high, low), multiples of 1 / 255 in [0, 1]. Error: 1.5 ULP, and a key within rounding of half a step may
// fall to either.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_pack_key(float key) {
    float inside = key > 0.0 ? (key < 1.0 ? key : 1.0) : 0.0;
    float whole = floor(inside * 65535.0 + 0.5);
    float high = floor(whole * 0.00390625);
    return vec2(high, whole - 256.0 * high) / 255.0;
}

// key from its two bytes (CS-Q-unpack): `(256 high + low) / 65535` [McGuire, Mara and Luebke 2012 (Scalable Ambient
// Obscurance), made exact].
// packed_key: (high, low), as gloam_pack_key gave them or as an 8-bit channel returned them: multiples of 1 / 255 in
// [0, 1]. Others are rounded to the nearest, outside [0, 1] taken to the nearer end, NaN to 0.
// Returns a key in [0, 1], within 1 / 131070 of the one that was packed. Error: 1.5 ULP; 3.5 by any device that keeps
// Vulkan's rules.
// No method or pass here calls it: it is there to be copied.
float gloam_unpack_key(vec2 packed_key) {
    vec2 inside =
        vec2(packed_key.x > 0.0 ? min(packed_key.x, 1.0) : 0.0, packed_key.y > 0.0 ? min(packed_key.y, 1.0) : 0.0);
    vec2 bytes = floor(inside * 255.0 + 0.5);
    return min((256.0 * bytes.x + bytes.y) / 65535.0, 1.0);
}

#endif
