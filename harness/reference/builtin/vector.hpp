// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

inline double builtin_dot(dvec3 a, dvec3 b) {
    return dot(a, b);
}
inline double builtin_length(dvec3 v) {
    return length(v);
}
inline double builtin_distance(dvec3 a, dvec3 b) {
    return distance(a, b);
}
inline dvec3 builtin_normalize(dvec3 v) {
    return normalize(v);
}
inline dvec3 builtin_cross(dvec3 a, dvec3 b) {
    return cross(a, b);
}
inline dvec3 builtin_reflect(dvec3 incident, dvec3 normal) {
    return glm::reflect(incident, normal);
}
inline dvec3 builtin_refract(dvec3 incident, dvec3 normal, double eta) {
    return glm::refract(incident, normal, eta);
}
inline dvec3 builtin_faceforward(dvec3 normal, dvec3 incident, dvec3 side) {
    if (dot(side, incident) < 0.0) return normal;
    return -normal;
}

// Rows of the matrix times the vector.
inline dvec3 builtin_matrix_vector(dmat3 m, dvec3 v) {
    return m * v;
}
inline dvec3 builtin_vector_matrix(dvec3 v, dmat3 m) {
    return v * m;
}
inline dmat3 builtin_matrix_matrix(dmat3 a, dmat3 b) {
    return a * b;
}
inline dvec4 builtin_matrix4_vector(dmat4 m, dvec4 v) {
    return m * v;
}
inline dmat3 builtin_outer_product(dvec3 a, dvec3 b) {
    return glm::outerProduct(a, b);
}
inline double builtin_determinant(dmat3 m) {
    return glm::determinant(m);
}
inline dmat3 builtin_inverse(dmat3 m) {
    return glm::inverse(m);
}

}  // namespace gloam::reference
