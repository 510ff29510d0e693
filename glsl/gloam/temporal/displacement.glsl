// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_DISPLACEMENT_GLSL
#define GLOAM_TEMPORAL_DISPLACEMENT_GLSL

// How a surface point has moved otherwise than the camera since the last frame, in 32 bits: three components of nine
// bits, with a sign, and a common exponent of five. Samples that watch for moving objects (TSSAO-9) read it at each
// tap. A previous position of four floats is four times as much memory.

// The code of what is too far to be held, or not known: 255 * 2^31 units along each axis.
const uint GLOAM_DISPLACED_FAR = 0xFBFDFEFFu;

// displacement in 32 bits (DISPLACED-code): `27 bits of components, 5 of their exponent` [gloam: the motion that
// TSSAO's equation 9 reads, in 32 bits].
// A displacement in 32 bits, rounded to the unit, or to 1/256 of its largest component where that is more.
// displacement: world units, of components whose sizes sum to 255 * 2^31 units at most. unit: world units, from 1e-30
// to 1e30.
// Returns the code, 0 for what is below half a unit; GLOAM_DISPLACED_FAR for what is larger, infinite or NaN. Within
// rounding of the middle of two codes, or of what is too large, either is returned.
uint gloam_displacement_to_code(vec3 displacement, float unit) {
    const float most = 547608330240.0;  // 255 * 2^31
    const uint least = 134u;            // the exponent of a float from 128 on, which eight bits hold
    const float integers = 12582912.0;  // 3 * 2^22: the lowest bits of a sum with it are the other number, rounded
    float units = 1.0 / unit;
    vec3 size = abs(displacement);
    if (!((size.x + size.y + size.z) * units <= most)) return GLOAM_DISPLACED_FAR;
    // What would round to 256 takes the next exponent.
    float largest = max(max(size.x, size.y), size.z) * units * (256.0 / 255.5);
    uint exponent = max(floatBitsToUint(largest) >> 23u, least) - least;
    vec3 scaled = displacement * (units * uintBitsToFloat((127u - exponent) << 23u));
    uvec3 bits = floatBitsToUint(scaled + integers) & 0x1FFu;
    return bits.x | bits.y << 9u | bits.z << 18u | exponent << 27u;
}

// displacement from 32 bits (DISPLACED-of): `the inverse of DISPLACED-code` [gloam: the motion that TSSAO's equation 9
// reads, in 32 bits].
// The displacement of a code, world units. code: any. unit: that of the code, world units, > 0.
// Error: 1 ULP.
vec3 gloam_displacement_from_code(uint code, float unit) {
    float scale = unit * uintBitsToFloat(((code >> 27u) + 127u) << 23u);
    return vec3(int(code << 23u) >> 23, int(code << 14u) >> 23, int(code << 5u) >> 23) * scale;
}

#endif
