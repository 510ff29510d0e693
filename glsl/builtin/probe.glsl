// SPDX-License-Identifier: MIT
#ifndef BUILTIN_PROBE_GLSL
#define BUILTIN_PROBE_GLSL

// Questions to a driver and its compiler, each of which some of them got wrong.

// isnan() of arithmetic (PROBE-isnan): `isnan(x - x)` [defects met in drivers and compilers].
// Whether NaN is noticed where the compiler can see that it comes of arithmetic.
bool probe_isnan_of_difference(float x) {
    return isnan(x - x);
}
// NaN differs from itself (PROBE-self): `x != x` [defects met in drivers and compilers].
bool probe_differs_from_itself(float x) {
    return x != x;
}

// contracted expression (recorded) (PROBE-contraction): `a b - c, c = a b rounded; 0 when nothing is contracted`
// [defects met in drivers and compilers].
// a b - c, where c is a b rounded to nearest: 0 unless the product was never rounded.
float probe_contraction(float a, float b, float c) {
    return a * b - c;
}

struct ProbeProduct {
    float value;
};

ProbeProduct probe_product(float a, float b) {
    precise float product = a * b;
    return ProbeProduct(product);
}

// precise through a function and a struct (recorded) (PROBE-precise-struct): `a b - c, c = a b rounded; 0 when precise
// holds` [defects met in drivers and compilers].
// The same with the product made precise and passed through a function and a struct.
float probe_precise_in_struct(float a, float b, float c) {
    precise float difference = probe_product(a, b).value - c;
    return difference;
}

// how often fma() rounds (recorded) (PROBE-fma): `fma(a, b, -c), c = a b rounded; 0 when it rounds twice` [defects met
// in drivers and compilers].
// The same by fma(), which may be rounded once or twice.
float probe_fma_rounding(float a, float b, float c) {
    return fma(a, b, -c);
}

// normalize() of -0 (recorded) (PROBE-normalize-sign): `sign bits of normalize(v)` [defects met in drivers and
// compilers].
// The sign bits of a normalised vector, 1 for x, 2 for y, 4 for z; a component of -0 should stay -0.
float probe_normalize_sign(vec3 v) {
    vec3 n = normalize(v);
    uvec3 signs = uvec3(floatBitsToUint(n.x), floatBitsToUint(n.y), floatBitsToUint(n.z)) >> 31u;
    return float(signs.x + 2u * signs.y + 4u * signs.z);
}

// folded constant against run time (PROBE-folded-exp): `exp(0.5) - exp(x), x = 0.5` [defects met in drivers and
// compilers].
// A function of a constant, which a compiler folds, less the same at run time.
float probe_folded_exp(float half_) {
    return exp(0.5) - exp(half_);
}
// folded constant against run time (PROBE-folded-sin): `sin(0.5) - sin(x), x = 0.5` [defects met in drivers and
// compilers].
float probe_folded_sin(float half_) {
    return sin(0.5) - sin(half_);
}

// power of zeros (recorded) (PROBE-pow): `pow(0, 0)` [defects met in drivers and compilers].
float probe_pow_of_zeros(float x, float y) {
    return pow(x, y);
}

// x % x is 0 (PROBE-remainder): `x % x, x > 0` [defects met in drivers and compilers].
// 0 for every positive x.
int probe_integer_remainder(int x) {
    return x % x;
}

#endif
