// SPDX-License-Identifier: MIT
// What is made of the occlusion.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/shading.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

// The sums over a few directions.
Values sums() {
    return made_by<glm::vec4>([](numeric::Random& random) {
        glm::dvec4 bent(0);
        const std::uint64_t directions = random.below(12);
        for (std::uint64_t i = 0; i < directions; ++i) {
            const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1));
            bent += random.unit() * glm::dvec4(glm::normalize(v), 1.0);
        }
        return bent;
    });
}

void add_cone(Entries& entries, const char* id, double (*reference)(double), double absolute) {
    const Values value = either(uniform(0, 1), either(log_uniform(1e-12, 1), uniform(0.999, 1.001)))
                             .and_near({0.5, 1.0})
                             .and_special();
    add(entries, id, reference, {value}, {.absolute = absolute}, {0, 1.5707965});
}

Values colours() {
    return either(vector(3, uniform(0, 1)), vector(3, any_float())).and_special();
}

Values offsets() {
    return offsets_of(uniform(0, 2), log_uniform(1e-20, 1e20));
}

// Radiance for which the errors are stated.
bool dim(glm::dvec3 radiance) {
    return !(radiance.x > 1 || radiance.y > 1 || radiance.z > 1);
}

// In half of the inputs two surfaces approximately face each other, some of them at the kernel's radius. At
// random hardly any light would pass between them.
void face_each_other(std::span<Word> words) {
    const auto at = [&](std::size_t i) {
        return glm::dvec3(from_word<double>(words[i]), from_word<double>(words[i + 1]),
                          from_word<double>(words[i + 2]));
    };
    const double reach = glm::length(at(0));
    const bool unit = is_unit(at(3)) && is_unit(at(6)) && reach > 1e-18 && reach < 1e18;
    if (words[0] % 2U == 0 || !unit) return;
    const auto turn = [&](std::size_t i, const glm::dvec3& towards) {
        const glm::dvec3 n = glm::normalize(towards + 0.5 * at(i));
        for (int k = 0; k < 3; ++k) words[i + static_cast<std::size_t>(k)] = to_word(n[k]);
    };
    turn(3, at(0) / reach);
    turn(6, -at(0) / reach);
    if (words[1] % 2U == 0) words[12] = to_word(0.99 * reach);
}

void append_light(Entries& entries) {
    add(entries, "CS-D-radiance", &reference::gloam_ssdo_radiance, {colours()}, {}, {0, 65504});
    add(entries, "CS-D", &reference::gloam_ssdo_direct, {offsets(), normals(), colours(), shares()},
        {.absolute = 6e-7}, {0, 131008.1}, [](glm::dvec3 w, glm::dvec3 n, glm::dvec3 radiance, double) {
            return small(w) && is_unit(n) && dim(radiance);
        });
    const Values length = either(log_uniform(0.1, 1), any_float()).and_near({1.0}).and_special();
    add(entries, "CS-D-bounce", &reference::gloam_ssdo_bounce,
        Domain{offsets(), normals(), normals(), colours(), length, length, shares()}.adjusted(
            face_each_other),
        {.absolute = 6e-7}, {0, 7e10},
        [](glm::dvec3 v, glm::dvec3 n, glm::dvec3 s, glm::dvec3 radiance, double radius, double least,
           double) {
            const bool near_one = !(radius > std::max(glm::length(v), least));
            return small(v) && is_unit(n) && is_unit(s) && dim(radiance) && near_one && !(least < 1e-18);
        });
    const Values count =
        made_by<float>([](numeric::Random& random) { return static_cast<float>(1 + random.below(64)); });
    add(entries, "CS-D-light", &reference::gloam_ssdo_light,
        {either(vector(3, uniform(0, 64)), vector(3, any_float())).and_special(),
         either(count, any_float()).and_special(), vector(3, uniform(0, 1)).and_special()},
        {.ulp = 3}, {0, 0x1.fffffep127}, [](glm::dvec3 sum, double n, glm::dvec3 albedo) {
            return moderate(1e-9, 1e9, sum, albedo) && moderate(1e-9, 1e9, n);
        });
    const Values depth = either(uniform(0, 1), log_uniform(1e-3, 1e6)).and_special();
    add(entries, "CS-R", &reference::gloam_depth_darkening,
        {depth, depth, either(uniform(0, 4), any_float()).and_special()}, {.ulp = 2}, {-0x1.fffffep127, 0},
        [](double d, double blurred, double strength) {
            return moderate(1e-9, 1e9, d, blurred, strength) && std::isfinite(strength);
        });
}

}  // namespace

void append_shading(Entries& entries) {
    const Values visibility = uniform(0, 1).and_near({0.0, 0.5, 1.0}).and_special();
    const Values offset = either(uniform(-0.5, 0.5), constant(0.0F)).and_near({0.5}).and_special();
    const Values brightness = uniform(0.5, 2).and_near({1.0}).and_special();
    const Values contrast = uniform(0.25, 8).and_near({0.0, 1.0, 2.0}).and_value(-1.0F).and_special();
    add(entries, "CS-REMAP", &reference::gloam_remap, {visibility, offset, brightness, contrast},
        {.absolute = 2e-6, .backward_ulp = 2}, {0, 1}, [](double ao, double a, double b, double c) {
            return moderate(1e-18, 1e18, ao, a, b) && moderate(1e-3, 16, c);
        });
    add(entries, "GTAO-bounce", &reference::gloam_multi_bounce, {visibility, vector(3, visibility)},
        {.absolute = 1.5e-6}, {0, 1});
    add(entries, "CS-L-add", &reference::gloam_bent_add, {sums(), normals(), uniform(0, 1).and_special()},
        {.absolute = 1e-6}, {-numeric::largest_float, numeric::largest_float},
        [](glm::dvec4 bent, glm::dvec3 w, double) { return moderate(0.0, 16, bent, w); });
    add(entries, "CS-L", &reference::gloam_bent_normal, {sums().and_special(), unit_vector(3)}, {.ulp = 3},
        {-1.000001, 1.000001});
    add(entries, "CS-L-length", &reference::gloam_bent_length, {sums().and_value(glm::vec4(0)).and_special()},
        {.absolute = 4e-7}, {0, 1}, [](glm::dvec4 bent) {
            return moderate(1e-18, 1e18, bent) && std::abs(bent.w) < 1e18 &&
                   glm::length(glm::dvec3(bent)) < 1e18;
        });
    add_cone(entries, "CS-L-cone", &reference::gloam_cone_angle, 4e-7);
    append_light(entries);
}

}  // namespace gloam::catalogue
