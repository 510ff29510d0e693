// SPDX-License-Identifier: MIT
#ifndef BUILTIN_VECTOR_GLSL
#define BUILTIN_VECTOR_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

// as Vulkan promises: inherited from the sum of products (BUILTIN-dot): `dot(a, b)` [Vulkan's rules].
float builtin_dot(vec3 a, vec3 b) {
    return dot(a, b);
}
// as Vulkan promises: inherited from sqrt(dot(v, v)) (BUILTIN-length): `length(v)` [Vulkan's rules].
float builtin_length(vec3 v) {
    return length(v);
}
// as Vulkan promises: inherited from length(a - b) (BUILTIN-distance): `distance(a, b)` [Vulkan's rules].
float builtin_distance(vec3 a, vec3 b) {
    return distance(a, b);
}
// as Vulkan promises: inherited from v inversesqrt(dot(v, v)) (BUILTIN-normalize): `normalize(v)` [Vulkan's rules].
vec3 builtin_normalize(vec3 v) {
    return normalize(v);
}
// as Vulkan promises: products and a difference (BUILTIN-cross): `cross(a, b)` [Vulkan's rules].
vec3 builtin_cross(vec3 a, vec3 b) {
    return cross(a, b);
}
// as Vulkan promises: inherited from i - 2 dot(n, i) n (BUILTIN-reflect): `reflect(i, n)` [Vulkan's rules].
vec3 builtin_reflect(vec3 incident, vec3 normal) {
    return reflect(incident, normal);
}
// as Vulkan promises: inherited from its formula (BUILTIN-refract): `refract(i, n, eta)` [Vulkan's rules].
vec3 builtin_refract(vec3 incident, vec3 normal, float eta) {
    return refract(incident, normal, eta);
}
// as Vulkan promises: dot(s, i) < 0 ? n : -n (BUILTIN-faceforward): `faceforward(n, i, s)` [Vulkan's rules].
vec3 builtin_faceforward(vec3 normal, vec3 incident, vec3 side) {
    return faceforward(normal, incident, side);
}
// as Vulkan promises: inherited from the sum of products (BUILTIN-matrix_vector): `m v` [Vulkan's rules].
vec3 builtin_matrix_vector(mat3 m, vec3 v) {
    return m * v;
}
// as Vulkan promises: inherited from the sum of products (BUILTIN-vector_matrix): `v m` [Vulkan's rules].
vec3 builtin_vector_matrix(vec3 v, mat3 m) {
    return v * m;
}
// as Vulkan promises: inherited from the sum of products (BUILTIN-matrix_matrix): `a b` [Vulkan's rules].
mat3 builtin_matrix_matrix(mat3 a, mat3 b) {
    return a * b;
}
// as Vulkan promises: inherited from the sum of products (BUILTIN-matrix4_vector): `m v` [Vulkan's rules].
vec4 builtin_matrix4_vector(mat4 m, vec4 v) {
    return m * v;
}
// as Vulkan promises: correctly rounded (BUILTIN-outer_product): `outerProduct(a, b)` [Vulkan's rules].
mat3 builtin_outer_product(vec3 a, vec3 b) {
    return outerProduct(a, b);
}
// as Vulkan promises: nothing; recorded (BUILTIN-determinant): `determinant(m)` [Vulkan's rules].
float builtin_determinant(mat3 m) {
    return determinant(m);
}
// as Vulkan promises: nothing; recorded (BUILTIN-inverse): `inverse(m)` [Vulkan's rules].
mat3 builtin_inverse(mat3 m) {
    return inverse(m);
}

#endif
