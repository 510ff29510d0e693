// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/methods.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera;
using Kernel = reference::GloamKernel;
using Estimate = reference::GloamEstimate;
using reference::GloamCamera;
using reference::GloamKernel;

constexpr double most_samples = 64;

void append_disc(Entries& entries) {
    entries.push_back(equation<glm::vec2(unsigned)>(
        {.id = "POISSON-disc",
         .function = "gloam_poisson_disc",
         .file = "gloam/sampling/poisson_disc.glsl",
         .title = "point of a Poisson disc of 64",
         .formula = "radius sqrt((i' + 1/2) / 64), i' the index with its bits reversed, at the emptiest of "
                    "4096 angles",
         .source = "Sourimant et al. 2011 (the pattern); construction after Mitchell's best candidates"},
        &reference::gloam_poisson_disc,
        {.domain = {log_integers(16777216).and_near_integers({64, 16777216, 4294967295})},
         .codomain = {-1, 1}}));
}

void append_poisson(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamPoisson);
    entries.push_back(equation<Signature>(
        {.id = "RAY-gather",
         .function = "gloam_poisson",
         .file = "gloam/methods/poisson.glsl",
         .title = "occlusion of a pixel by rays of a lifted Poisson disc",
         .formula = "share of the rays that are blocked",
         .source = "Sourimant et al. 2011, CS-J"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamPoisson& own) {
            return reference::gloam_poisson(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({gather_length(), integers(1, 4)})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.ulp = 1, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                          const Kernel& k, const auto&) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

void append_sphere_proxy(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamSphereProxy);
    entries.push_back(equation<Signature>(
        {.id = "PROXY-gather",
         .function = "gloam_sphere_proxy",
         .file = "gloam/methods/sphere_proxy.glsl",
         .title = "occlusion of a pixel by its surroundings as balls",
         .formula = "intensity times the sum of 2 rho_i M C(p, s_i), M the pixels of the disc, rho_i uniform",
         .source = "Shanmugam and Arikan 2007, CS-H"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamSphereProxy& own) {
            return reference::gloam_sphere_proxy(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({uniform(0, 2).and_special()})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 1e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                          const Kernel& k, const auto&) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

}  // namespace

void append_ray_gathers(Entries& entries) {
    append_disc(entries);
    append_poisson(entries);
    append_sphere_proxy(entries);
}

}  // namespace gloam::catalogue
