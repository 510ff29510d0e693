// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"

#include <cmath>
#include <numbers>

namespace gloam::catalogue {
namespace {

using numeric::Random;

glm::dvec3 direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// Rodrigues' rotation about a random axis.
glm::dmat4 rotation(Random& random, double largest_angle) {
    const glm::dvec3 k = direction(random);
    const double angle = random.uniform(-largest_angle, largest_angle);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const glm::dmat3 across(0.0, k.z, -k.y, -k.z, 0.0, k.x, k.y, -k.x, 0.0);
    return glm::dmat4(c * glm::dmat3(1.0) + (1.0 - c) * glm::outerProduct(k, k) + s * across);
}

glm::dmat4 rigid(Random& random, double largest_angle, double extent) {
    glm::dmat4 matrix = rotation(random, largest_angle);
    matrix[3] = glm::dvec4(direction(random) * random.uniform(0.0, extent), 1.0);
    return matrix;
}

// Depth d is mapped to (p22 z + p32) / -z; the four kinds of projection differ in these two elements.
glm::dmat4 projection(Random& random) {
    const double near = random.uniform(0.1, 1.0);
    const double far = random.uniform(20.0, 200.0);
    const bool infinite = random.below(2) == 0;
    const bool reversed = random.below(2) == 0;
    double p22 = infinite ? -1.0 : far / (near - far);
    double p32 = infinite ? -near : far * near / (near - far);
    if (reversed) {
        p22 = -1.0 - p22;
        p32 = -p32;
    }
    const double focal = random.uniform(0.7, 2.0);
    glm::dmat4 matrix(0.0);
    matrix[0][0] = focal / random.uniform(0.6, 2.0);
    matrix[1][1] = -focal;
    matrix[2][2] = p22;
    matrix[2][3] = -1.0;
    matrix[3][2] = p32;
    return matrix;
}

}  // namespace

check::Values rigid_matrices(double extent) {
    return check::made_by<glm::mat4>(
        [extent](Random& random) { return rigid(random, std::numbers::pi, extent); });
}

check::Values projection_matrices() {
    return check::made_by<glm::mat4>([](Random& random) { return projection(random); });
}

check::Values inverse_projection_matrices() {
    return check::made_by<glm::mat4>([](Random& random) { return glm::inverse(projection(random)); });
}

check::Values reprojection_matrices() {
    return check::made_by<glm::mat4>([](Random& random) {
        const glm::dmat4 p = projection(random);
        return p * rigid(random, 0.5, 1.0) * glm::inverse(p);
    });
}

check::Values clip_points() {
    return check::made_by<glm::vec4>([](Random& random) {
        const glm::dvec4 point(random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1), random.unit(), 1.0);
        const double w = random.below(2) == 0 ? 1.0 : std::exp(random.uniform(std::log(0.1), std::log(10.0)));
        return point * w;
    });
}

check::Values projection_scales() {
    return check::vector(
        {check::log_uniform(0.3, 5.0).and_near({1.0}), check::signed_log_uniform(0.3, 5.0).and_near({-1.0})});
}

}  // namespace gloam::catalogue
