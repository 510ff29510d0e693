// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {

using namespace subject;
using numeric::Random;

namespace {

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

constexpr glm::ivec2 sizes[] = {{1, 1}, {3, 5}, {17, 9}, {64, 2}, {1, 33}, {29, 43}};

// Two slanted surfaces, one in front of the other, with a few background pixels.
Image surface_depth(glm::ivec2 size, numeric::Random& random) {
    const float slope_x = static_cast<float>(random.uniform(-0.02, 0.02));
    const float slope_y = static_cast<float>(random.uniform(-0.02, 0.02));
    return make_image<float>(size, [&](glm::ivec2 pixel) {
        if (random.below(16) == 0) return std::numeric_limits<float>::infinity();
        const float base = (pixel.x + 2 * pixel.y) % 7 < 3 ? 2.0F : 3.0F;
        return base + slope_x * static_cast<float>(pixel.x) + slope_y * static_cast<float>(pixel.y);
    });
}

Image no_surface(glm::ivec2 size) {
    return make_image<float>(size, [](glm::ivec2) { return std::numeric_limits<float>::infinity(); });
}

}  // namespace

Values rigid_matrices(double extent) {
    return made_by<glm::mat4>([extent](Random& random) { return rigid(random, std::numbers::pi, extent); });
}

Values projection_matrices() {
    return made_by<glm::mat4>([](Random& random) { return projection(random); });
}

Values inverse_projection_matrices() {
    return made_by<glm::mat4>([](Random& random) { return glm::inverse(projection(random)); });
}

Values reprojection_matrices() {
    return made_by<glm::mat4>([](Random& random) {
        const glm::dmat4 p = projection(random);
        return p * rigid(random, 0.5, 1.0) * glm::inverse(p);
    });
}

Values clip_points() {
    return made_by<glm::vec4>([](Random& random) {
        const glm::dvec4 point(random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1), random.unit(), 1.0);
        const double w = random.below(2) == 0 ? 1.0 : std::exp(random.uniform(std::log(0.1), std::log(10.0)));
        return point * w;
    });
}

Values projection_scales() {
    return vector({log_uniform(0.3, 5.0).and_near({1.0}), signed_log_uniform(0.3, 5.0).and_near({-1.0})});
}

Values cameras() {
    return vector({log_uniform(0.5, 3).and_special(), signed_log_uniform(0.5, 3).and_special(), image_size(),
                   booleans()});
}

Values shares() {
    return uniform(0, 1).and_near({0.0, 1.0}).and_special();
}

Values normals() {
    return unit_vector(3).and_special();
}

Values offsets_of(const Values& usual, const Values& any) {
    return either(vector_of_length(3, usual), vector_of_length(3, any)).and_value(glm::vec3(0)).and_special();
}

Values facing_slices() {
    return made_by<reference::GloamSlice>([](Random& random) {
               const auto leaning = [&](double most) {
                   return glm::normalize(
                       glm::vec3(random.uniform(-most, most), random.uniform(-most, most), 1));
               };
               const glm::vec3 view = leaning(0.5);
               const glm::vec3 normal = leaning(1);
               const auto turn = static_cast<float>(random.uniform(0, 3.1415926));
               return reference::gloam_slice(glm::vec2(std::cos(turn), std::sin(turn)), view, normal);
           })
        .only_as_drawn();
}

Values image_axes() {
    return made_by<glm::ivec2>(
        [](Random& random) { return random.below(2) == 0 ? glm::ivec2(1, 0) : glm::ivec2(0, 1); });
}

std::function<void(std::span<Word>)> place_before_camera(std::size_t position, std::size_t camera) {
    return [position, camera](std::span<Word> words) {
        const auto number = [&](std::size_t i) { return from_word<double>(words[i]); };
        const glm::dvec2 ndc(number(position), number(position + 1));
        const glm::dvec2 scale(number(camera), number(camera + 1));
        const double depth = number(position + 2);
        const bool drawn = std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0 && depth >= 1.0 && depth <= 4.0;
        if (!drawn) return;
        const bool orthographic = words[camera + 4] != 0U;
        const glm::dvec2 side = ndc / scale * (orthographic ? 1.0 : depth);
        words[position] = to_word(side.x);
        words[position + 1] = to_word(side.y);
        words[position + 2] = to_word(-depth);
    };
}

std::vector<ImageScenario> image_scenarios(
    const std::function<ImageSet(glm::ivec2 size, numeric::Random& random)>& make) {
    std::vector<ImageScenario> scenarios;
    for (const glm::ivec2 size : sizes) {
        scenarios.push_back({.name = fmt::format("{} x {}", size.x, size.y), .size = size, .make = make});
    }
    return scenarios;
}

float occlusion_or_worse(Random& random) {
    constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                             -0.25F, 1.5F};
    return random.below(32) == 0 ? bad[random.below(4)] : static_cast<float>(random.unit());
}

std::vector<ImageScenario> depth_scenarios(const std::string& prototype) {
    auto scenarios = image_scenarios([prototype](glm::ivec2 size, numeric::Random& random) {
        return ImageSet{{prototype, surface_depth(size, random)}};
    });
    scenarios.push_back(
        {.name = "all background", .size = {5, 4}, .make = [prototype](glm::ivec2 size, numeric::Random&) {
             return ImageSet{{prototype, no_surface(size)}};
         }});
    return scenarios;
}

}  // namespace gloam::catalogue
