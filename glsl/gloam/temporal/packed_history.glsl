// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_PACKED_HISTORY_GLSL
#define GLOAM_TEMPORAL_PACKED_HISTORY_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/temporal/history.glsl"

// A history in four times 16 bits: half of what floats take, and closer than four half floats are.
struct GloamPackedHistory {
    uint occlusion;  // in 1/32768: 0 and 1 are exact
    uint weight;     // in 1/16, to 4095
    uint index;      // modulo 65536
    uint depth;      // gloam_depth_to_code
};

// The most samples in the mean, and the largest table of samples, that a packed history holds.
const float GLOAM_PACKED_WEIGHT_MAX = 4095.0;
const uint GLOAM_PACKED_TABLE = 65536u;

// nearest integer, by no operation that rounds (PACKED-round): `floor(x + 1/2)` [gloam: the layout of TSSAO's
// ambient-occlusion buffer in 64 bits].
// x to the nearest integer, a half away from 0, with no operation that rounds. x: in [0, 2^23]. Error: none.
uint gloam_round_half_up(float x) {
    float whole = floor(x);
    return uint(whole) + (x - whole >= 0.5 ? 1u : 0u);
}

// depth in 16 bits (PACKED-depth): `6 bits of exponent, 10 of mantissa; 65535 for background` [gloam: the layout of
// TSSAO's ambient-occlusion buffer in 64 bits].
// Eye-linear depth in 16 bits: six of exponent and ten of mantissa, rounded to nearest.
// depth: world units; from 2^-31 to 2^32: nearer and further ones become the nearest and the furthest of these.
// Returns 1 to 64513; 65535 for background. Error: none; gloam_depth_from_code is within 2^-11 of the depth,
// relatively.
uint gloam_depth_to_code(float depth) {
    if (gloam_is_background(depth)) return 65535u;
    const uint dropped = 13u;          // bits of a float's mantissa
    const uint smallest = 96u << 23u;  // 2^-31
    const uint largest = 159u << 23u;  // 2^32
    uint bits = clamp(floatBitsToUint(depth), smallest, largest);
    return ((bits - smallest + (1u << (dropped - 1u))) >> dropped) + 1u;
}

// depth from 16 bits (PACKED-depth-of): `the inverse of PACKED-depth` [gloam: the layout of TSSAO's ambient-occlusion
// buffer in 64 bits].
// The depth of a code; 0 for 0, which no depth has, and +infinity from 65535 on. Error: none.
float gloam_depth_from_code(uint code) {
    if (code == 0u) return 0.0;
    if (code >= 65535u) return gloam_background_depth();
    return uintBitsToFloat(((code - 1u) << 13u) + (96u << 23u));
}

// history in 64 bits (PACKED-encode): `(32768 AO, 16 w, j, code of d), rounded` [gloam: the layout of TSSAO's
// ambient-occlusion buffer in 64 bits].
// A history in 64 bits, sanitized first. The mean stops short of where it should be by up to 1.6e-5 (w_max + k) / k:
// 2.5e-4 for k = 32 and w_max = 500; its limits are GLOAM_PACKED_WEIGHT_MAX and GLOAM_PACKED_TABLE. h: any history.
// Each member fits 16 bits. Error: none but the rounding to what the members hold.
GloamPackedHistory gloam_history_encode(GloamHistory h) {
    GloamHistory s = gloam_history_sanitize(h);
    return GloamPackedHistory(gloam_round_half_up(s.occlusion * 32768.0),
                              gloam_round_half_up(min(s.weight, GLOAM_PACKED_WEIGHT_MAX) * 16.0),
                              s.index % GLOAM_PACKED_TABLE, gloam_depth_to_code(s.depth));
}

// texel that 64 bits stand for (PACKED-texel): `(AO, w, j, d), the inverse of PACKED-encode` [gloam: the layout of
// TSSAO's ambient-occlusion buffer in 64 bits].
// The texel that 64 bits stand for, as gloam_history_pack gives it but not sanitized: for gloam_history_unpack, and
// what reads through it.
// texel: members are taken modulo 65536. Returns (occlusion, weight, index, depth). Error: none.
vec4 gloam_packed_texel(GloamPackedHistory texel) {
    const uint mask = 0xFFFFu;
    return vec4(float(texel.occlusion & mask) * (1.0 / 32768.0), float(texel.weight & mask) * (1.0 / 16.0),
                float(texel.index & mask), gloam_depth_from_code(texel.depth & mask));
}

// history from 64 bits (PACKED-decode): `the same, sanitized` [gloam: the layout of TSSAO's ambient-occlusion buffer in
// 64 bits].
// The history of 64 bits, sanitized; whatever they hold, the result is usable. Zeros are the empty history of
// background.
// texel: members are taken modulo 65536. Error: none.
GloamHistory gloam_history_decode(GloamPackedHistory texel) {
    return gloam_history_unpack(gloam_packed_texel(texel));
}

#endif
