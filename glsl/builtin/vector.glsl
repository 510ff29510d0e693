// SPDX-License-Identifier: MIT
#ifndef BUILTIN_VECTOR_GLSL
#define BUILTIN_VECTOR_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

float builtin_dot(vec3 a, vec3 b) {
    return dot(a, b);
}
float builtin_length(vec3 v) {
    return length(v);
}
float builtin_distance(vec3 a, vec3 b) {
    return distance(a, b);
}
vec3 builtin_normalize(vec3 v) {
    return normalize(v);
}
vec3 builtin_cross(vec3 a, vec3 b) {
    return cross(a, b);
}
vec3 builtin_reflect(vec3 incident, vec3 normal) {
    return reflect(incident, normal);
}
vec3 builtin_refract(vec3 incident, vec3 normal, float eta) {
    return refract(incident, normal, eta);
}
vec3 builtin_faceforward(vec3 normal, vec3 incident, vec3 side) {
    return faceforward(normal, incident, side);
}
vec3 builtin_matrix_vector(mat3 m, vec3 v) {
    return m * v;
}
vec3 builtin_vector_matrix(vec3 v, mat3 m) {
    return v * m;
}
mat3 builtin_matrix_matrix(mat3 a, mat3 b) {
    return a * b;
}
vec4 builtin_matrix4_vector(mat4 m, vec4 v) {
    return m * v;
}
mat3 builtin_outer_product(vec3 a, vec3 b) {
    return outerProduct(a, b);
}
float builtin_determinant(mat3 m) {
    return determinant(m);
}
mat3 builtin_inverse(mat3 m) {
    return inverse(m);
}

#endif
