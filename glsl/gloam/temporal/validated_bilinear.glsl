// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_VALIDATED_BILINEAR_GLSL
#define GLOAM_TEMPORAL_VALIDATED_BILINEAR_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Bilinear interpolation of the history that leaves out texels of another surface. The four texels are, in this order,
// (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) with (x, y) = floor(uv size - 1/2).

// weights of bilinear interpolation (BILINEAR): `((1 - x)(1 - y), x (1 - y), (1 - x) y, x y)` [definition].
// fraction: fract(uv size - 1/2), in [0, 1]^2; taken to the nearer end outside, 0 for NaN.
// Returns weights in [0, 1] of sum 1. Error: 2.5 ULP each.
vec4 gloam_bilinear_weights(vec2 fraction) {
    vec2 f = vec2(gloam_unit_interval(fraction.x), gloam_unit_interval(fraction.y));
    vec2 g = 1.0 - f;
    return vec4(g.x * g.y, f.x * g.y, g.x * f.y, f.x * f.y);
}

// bilinear weights of the valid texels only (BILINEAR-valid): `w_i / (sum of valid w)` [TSSAO,
// interpolation across depth edges].
// Weights of the texels that may be used, made to sum to 1 again.
// bilinear: weights as above; each read inside [0, 1], NaN as 0. valid: which texels passed their test
// (gloam_depth_consistent).
// Returns weights in [0, 1] of sum 1, 0 for invalid texels; all 0 where no valid texel has a weight that is not zero
// or subnormal.
// Error: 3 ULP each.
vec4 gloam_validated_weights(vec4 bilinear, bvec4 valid) {
    vec4 w = vec4(valid.x ? gloam_unit_interval(bilinear.x) : 0.0, valid.y ? gloam_unit_interval(bilinear.y) : 0.0,
                  valid.z ? gloam_unit_interval(bilinear.z) : 0.0, valid.w ? gloam_unit_interval(bilinear.w) : 0.0);
    float sum = (w.x + w.y) + (w.z + w.w);
    return sum >= GLOAM_SMALLEST ? min(w / sum, vec4(1.0)) : vec4(0.0);
}

#endif
