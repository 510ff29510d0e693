// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <span>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/shading.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* file = "gloam/shading/directional_occlusion.glsl";
constexpr const char* ssdo = "Ritschel, Grosch and Seidel 2009 (SSDO)";

Values colours() {
    return either(vector(3, uniform(0, 1)), vector(3, any_float())).and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values offsets() {
    return either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-20, 1e20)))
        .and_value(glm::vec3(0))
        .and_special();
}
bool small(glm::dvec3 v) {
    return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 1e18);
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

void append_terms(Entries& entries) {
    entries.push_back(equation<glm::vec3(glm::vec3)>({.id = "CS-D-radiance",
                                                      .function = "gloam_ssdo_radiance",
                                                      .file = file,
                                                      .title = "radiance that can be summed",
                                                      .formula = "clamp(L, 0, 65504)",
                                                      .source = "convention"},
                                                     &reference::gloam_ssdo_radiance,
                                                     {.domain = {colours()}, .codomain = {0, 65504}}));
    using Direct = glm::vec3(glm::vec3, glm::vec3, glm::vec3, float);
    const Values visibility = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(equation<Direct>(
        {.id = "CS-D",
         .function = "gloam_ssdo_direct",
         .file = file,
         .title = "light along one direction",
         .formula = "2 L V max(w . n, 0)",
         .source = ssdo},
        &reference::gloam_ssdo_direct,
        {.domain = {offsets(), normals(), colours(), visibility},
         .budget = {.absolute = 6e-7},
         .codomain = {0, 131008.1},
         .promised = make_predicate<Direct>([](glm::dvec3 w, glm::dvec3 n, glm::dvec3 radiance, double) {
             return small(w) && is_unit(n) && dim(radiance);
         })}));
    using Bounce = glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, float, float, float);
    const Values length = either(log_uniform(0.1, 1), any_float()).and_near({1.0}).and_special();
    entries.push_back(equation<Bounce>(
        {.id = "CS-D-bounce",
         .function = "gloam_ssdo_bounce",
         .file = file,
         .title = "light that one blocked sample bounces",
         .formula = "(1 - V) L R^2 max(cos_s, 0) max(cos_r, 0) / max(d, d_min)^2",
         .source = ssdo},
        &reference::gloam_ssdo_bounce,
        {.domain = Domain{offsets(), normals(), normals(), colours(), length, length, visibility}.adjusted(
             face_each_other),
         .budget = {.absolute = 6e-7},
         .codomain = {0, 7e10},
         .promised = make_predicate<Bounce>([](glm::dvec3 v, glm::dvec3 n, glm::dvec3 s, glm::dvec3 radiance,
                                               double radius, double least, double) {
             const bool near_one = !(radius > std::max(glm::length(v), least));
             return small(v) && is_unit(n) && is_unit(s) && dim(radiance) && near_one && !(least < 1e-18);
         })}));
}

void append_results(Entries& entries) {
    using Light = glm::vec3(glm::vec3, float, glm::vec3);
    const Values count =
        made_by<float>([](numeric::Random& random) { return static_cast<float>(1 + random.below(64)); });
    entries.push_back(equation<Light>(
        {.id = "CS-D-light",
         .function = "gloam_ssdo_light",
         .file = file,
         .title = "light that leaves the point",
         .formula = "rho sum / N",
         .source = ssdo},
        &reference::gloam_ssdo_light,
        {.domain = {either(vector(3, uniform(0, 64)), vector(3, any_float())).and_special(),
                    either(count, any_float()).and_special(), vector(3, uniform(0, 1)).and_special()},
         .budget = {.ulp = 2},
         .codomain = {0, 0x1.fffffep127},
         .promised = make_predicate<Light>([](glm::dvec3 sum, double n, glm::dvec3 albedo) {
             return moderate(1e-9, 1e9, sum, albedo) && moderate(1e-9, 1e9, n);
         })}));
    using Darkening = float(float, float, float);
    const Values depth = either(uniform(0, 1), log_uniform(1e-3, 1e6)).and_special();
    entries.push_back(equation<Darkening>(
        {.id = "CS-R",
         .function = "gloam_depth_darkening",
         .file = "gloam/shading/depth_darkening.glsl",
         .title = "depth darkening",
         .formula = "lambda min(G * D - D, 0)",
         .source = "Luft, Colditz and Deussen 2006"},
        &reference::gloam_depth_darkening,
        {.domain = {depth, depth, either(uniform(0, 4), any_float()).and_special()},
         .budget = {.ulp = 2},
         .codomain = {-0x1.fffffep127, 0},
         .promised = make_predicate<Darkening>([](double d, double blurred, double strength) {
             return moderate(1e-9, 1e9, d, blurred, strength) && std::isfinite(strength);
         })}));
}

}  // namespace

void append_shading_directional(Entries& entries) {
    append_terms(entries);
    append_results(entries);
}

}  // namespace gloam::catalogue
