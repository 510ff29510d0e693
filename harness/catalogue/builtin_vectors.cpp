// SPDX-License-Identifier: MIT
#include "catalogue/builtin_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/builtin.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using glm::mat3;
using glm::mat4;
using glm::vec3;
using glm::vec4;

constexpr const char* file = "vector.glsl";
constexpr const char* sums = "inherited from the sum of products";

Values vectors() {
    return either(vector(3, uniform(-2, 2)), vector(3, signed_log_uniform(1e-12, 1e12))).and_special();
}
template <class Matrix>
Values matrices() {
    return made_by<Matrix>([](numeric::Random& random) {
        Matrix m(1.0F);
        for (glm::length_t column = 0; column < Matrix::length(); ++column) {
            for (glm::length_t row = 0; row < Matrix::length(); ++row) {
                m[column][row] = static_cast<float>(random.uniform(-2, 2));
            }
        }
        return m;
    });
}

void append_products(Entries& entries) {
    append_builtin<float(vec3, vec3)>(entries, file, "dot", "dot(a, b)", sums, &reference::builtin_dot,
                                      {vectors(), vectors()});
    append_builtin<float(vec3)>(entries, file, "length", "length(v)", "inherited from sqrt(dot(v, v))",
                                &reference::builtin_length, {vectors()});
    append_builtin<float(vec3, vec3)>(entries, file, "distance", "distance(a, b)",
                                      "inherited from length(a - b)", &reference::builtin_distance,
                                      {vectors(), vectors()});
    append_builtin<vec3(vec3)>(entries, file, "normalize", "normalize(v)",
                               "inherited from v inversesqrt(dot(v, v))", &reference::builtin_normalize,
                               {vectors()});
    append_builtin<vec3(vec3, vec3)>(entries, file, "cross", "cross(a, b)", "products and a difference",
                                     &reference::builtin_cross, {vectors(), vectors()});
}

void append_optics(Entries& entries) {
    append_builtin<vec3(vec3, vec3)>(entries, file, "reflect", "reflect(i, n)",
                                     "inherited from i - 2 dot(n, i) n", &reference::builtin_reflect,
                                     {vectors(), vectors()});
    append_builtin<vec3(vec3, vec3, float)>(entries, file, "refract", "refract(i, n, eta)",
                                            "inherited from its formula", &reference::builtin_refract,
                                            {unit_vector(3), unit_vector(3), uniform(0.5, 2)});
    append_builtin<vec3(vec3, vec3, vec3)>(entries, file, "faceforward", "faceforward(n, i, s)",
                                           "dot(s, i) < 0 ? n : -n", &reference::builtin_faceforward,
                                           {vectors(), vectors(), vectors()});
}

void append_matrices(Entries& entries) {
    const Values m = matrices<mat3>();
    append_builtin<vec3(mat3, vec3)>(entries, file, "matrix_vector", "m v", sums,
                                     &reference::builtin_matrix_vector, {m, vectors()});
    append_builtin<vec3(vec3, mat3)>(entries, file, "vector_matrix", "v m", sums,
                                     &reference::builtin_vector_matrix, {vectors(), m});
    append_builtin<mat3(mat3, mat3)>(entries, file, "matrix_matrix", "a b", sums,
                                     &reference::builtin_matrix_matrix, {m, m});
    append_builtin<vec4(mat4, vec4)>(entries, file, "matrix4_vector", "m v", sums,
                                     &reference::builtin_matrix4_vector,
                                     {matrices<mat4>(), vector(4, uniform(-2, 2))});
    append_builtin<mat3(vec3, vec3)>(entries, file, "outer_product", "outerProduct(a, b)",
                                     "correctly rounded", &reference::builtin_outer_product,
                                     {vectors(), vectors()});
    append_builtin<float(mat3)>(entries, file, "determinant", "determinant(m)", "nothing; recorded",
                                &reference::builtin_determinant, {m});
    append_builtin<mat3(mat3)>(entries, file, "inverse", "inverse(m)", "nothing; recorded",
                               &reference::builtin_inverse, {m});
}

}  // namespace

void append_builtin_vectors(Entries& entries) {
    append_products(entries);
    append_optics(entries);
    append_matrices(entries);
}

}  // namespace gloam::catalogue
