// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

template <class T>
T builtin_dot(vec3<T> a, vec3<T> b) {
    return dot(a, b);
}
template <class T>
T builtin_length(vec3<T> v) {
    return length(v);
}
template <class T>
T builtin_distance(vec3<T> a, vec3<T> b) {
    return distance(a, b);
}
template <class T>
vec3<T> builtin_normalize(vec3<T> v) {
    return normalize(v);
}
template <class T>
vec3<T> builtin_cross(vec3<T> a, vec3<T> b) {
    return cross(a, b);
}
template <class T>
vec3<T> builtin_reflect(vec3<T> incident, vec3<T> normal) {
    return reflect(incident, normal);
}
template <class T>
vec3<T> builtin_refract(vec3<T> incident, vec3<T> normal, T eta) {
    const T cosine = dot(normal, incident);
    const T k = T(1) - eta * eta * (T(1) - cosine * cosine);
    if (k < T(0)) return vec3<T>(T(0), T(0), T(0));
    return eta * incident - (eta * cosine + sqrt(k)) * normal;
}
template <class T>
vec3<T> builtin_faceforward(vec3<T> normal, vec3<T> incident, vec3<T> side) {
    if (dot(side, incident) < T(0)) return normal;
    return -normal;
}

// Rows of the matrix times the vector.
template <class T>
vec3<T> builtin_matrix_vector(mat3<T> m, vec3<T> v) {
    return multiply(m, v);
}
template <class T>
vec3<T> builtin_vector_matrix(vec3<T> v, mat3<T> m) {
    return vec3<T>(dot(v, m[0]), dot(v, m[1]), dot(v, m[2]));
}
template <class T>
mat3<T> builtin_matrix_matrix(mat3<T> a, mat3<T> b) {
    return mat3<T>(multiply(a, b[0]), multiply(a, b[1]), multiply(a, b[2]));
}
template <class T>
vec4<T> builtin_matrix4_vector(mat4<T> m, vec4<T> v) {
    return multiply(m, v);
}
template <class T>
mat3<T> builtin_outer_product(vec3<T> a, vec3<T> b) {
    return mat3<T>(a * b.x, a * b.y, a * b.z);
}
template <class T>
T builtin_determinant(mat3<T> m) {
    return unspecified(dot(m[0], cross(m[1], m[2])));
}
// The columns' cross products over the determinant, transposed.
template <class T>
mat3<T> builtin_inverse(mat3<T> m) {
    const T determinant = dot(m[0], cross(m[1], m[2]));
    const mat3<T> rows(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    mat3<T> inverse = transpose(rows);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
            inverse[column][row] = unspecified(T(inverse[column][row] / determinant));
    }
    return inverse;
}

}  // namespace gloam::reference
