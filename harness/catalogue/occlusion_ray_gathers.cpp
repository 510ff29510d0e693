// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/methods/poisson.hpp"
#include "reference/methods/sphere_proxy.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera<float>;
using Kernel = reference::GloamKernel<float>;
using Method = reference::GloamMethod<float>;
using Ray = reference::GloamRay<float>;
using reference::GloamCamera;
using reference::GloamKernel;
using reference::GloamMethod;
using reference::GloamRay;
using reference::vec3;
using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Kernel, Method);

constexpr const char* rays = "passes/methods/poisson.glsl";
constexpr const char* proxies = "passes/methods/sphere_proxy.glsl";
constexpr double most_samples = 64;

Domain gather_domain() {
    return Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                  gather_methods()}
        .adjusted(place_before_camera(0, 6));
}

void append_disc(Entries& entries) {
    entries.push_back(equation<glm::vec2(unsigned)>(
        {.id = "POISSON-disc",
         .function = "gloam_poisson_disc",
         .file = "gloam/sampling/poisson_disc.glsl",
         .title = "point of a Poisson disc of 64",
         .formula = "radius sqrt((i' + 1/2) / 64), i' the index with its bits reversed, at the emptiest of "
                    "4096 angles",
         .source = "Sourimant et al. 2011 (the pattern); construction after Mitchell's best candidates"},
        GLOAM_REFERENCE(gloam_poisson_disc),
        {.domain = {log_integers(16777216).and_near_integers({64, 16777216, 4294967295})},
         .codomain = {-1, 1}}));
}

void append_march(Entries& entries) {
    using Signature = Ray(Ray, glm::vec3, glm::vec3, Camera, Kernel, Method);
    const Values ray = vector({unit_vector(3), uniform(0, 1), constant(glm::vec2(0, 0))});
    entries.push_back(equation<Signature>(
        {.id = "RAY-march",
         .function = "gloam_ray_march",
         .file = rays,
         .title = "all steps of a ray",
         .formula = "p + R (i + jitter) / n w, each projected, until blocked",
         .source = "Sourimant et al. 2011; Dimitrov, Bavoil and Sainz 2008"},
        []<class T>(const ImageSet& images, const GloamRay<T>& ray_of, vec3<T> position, vec3<T> normal,
                    const GloamCamera<T>& camera, const GloamKernel<T>& kernel,
                    const GloamMethod<T>& method) {
            return reference::gloam_ray_march(ray_of, position, normal, camera, kernel, method,
                                              reference::PoissonMethod<T>{}, depth_of<T>(images));
        },
        {.domain =
             Domain{ray, gather_positions(), unit_vector(3), cameras(), gather_kernels(), gather_methods()}
                 .adjusted(place_before_camera(6, 12)),
         .budget = {.backward_ulp = 4},
         .promised = make_predicate<Signature>(
             [](const Ray&, const glm::vec3& position, const glm::vec3& normal, const Camera& c,
                const Kernel& k, const Method& m) { return usual_gather(position, normal, c, k, m); }),
         .scenarios = depth_scenarios(depth_prototype)}));
}

void append_rays(Entries& entries) {
    entries.push_back(equation<unsigned(unsigned, unsigned)>(
        {.id = "RAY-samples",
         .function = "gloam_ray_samples",
         .file = rays,
         .title = "samples of whole rays",
         .formula = "n max(floor(k / n), 1)",
         .source = "definition"},
        GLOAM_REFERENCE(gloam_ray_samples),
        {.domain = {log_integers(100'000).and_near_integers({64, 4294967295}), integers(0, 64)},
         .scenarios = depth_scenarios(depth_prototype)}));
    entries.push_back(equation<Gather>(
        {.id = "RAY-gather",
         .function = "gloam_ray_gather",
         .file = rays,
         .title = "occlusion of a pixel by rays of a lifted Poisson disc",
         .formula = "n times the share of the rays that are blocked, n",
         .source = "Sourimant et al. 2011, CS-J"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_ray_gather(position, normal, camera, kernel, method,
                                               reference::PoissonMethod<T>{}, depth_of<T>(images));
        },
        {.domain = gather_domain(),
         .budget = {.ulp = 0.5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(depth_prototype)}));
}

void append_proxies(Entries& entries) {
    using Piece = float(glm::vec3, glm::vec3, glm::ivec2, Camera, Kernel, Method);
    entries.push_back(equation<Piece>(
        {.id = "PROXY-at",
         .function = "gloam_proxy_at",
         .file = proxies,
         .title = "contribution of the piece of surface at a pixel",
         .formula = "(r / D)^2 max(n . v / D, 0), r half the pixel's width there, D <= R, n . v > bias",
         .source = "Shanmugam and Arikan 2007, CS-H"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, glm::ivec2 at,
                    const GloamCamera<T>& camera, const GloamKernel<T>& kernel,
                    const GloamMethod<T>& method) {
            return reference::gloam_proxy_at(position, normal, at, camera, kernel, method,
                                             reference::SphereProxyMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), image_pixel(), cameras(),
                          gather_kernels(), gather_methods()}
                       .adjusted(place_before_camera(0, 8)),
         .budget = {.absolute = 1e-6, .backward_ulp = 4},
         .codomain = {0, 1},
         .promised = make_predicate<Piece>([](const glm::vec3& p, const glm::vec3& n, glm::ivec2,
                                              const Camera& c, const Kernel& k,
                                              const Method& m) { return usual_gather(p, n, c, k, m); }),
         .scenarios = depth_scenarios(depth_prototype)}));
    entries.push_back(equation<Gather>(
        {.id = "PROXY-gather",
         .function = "gloam_proxy_gather",
         .file = proxies,
         .title = "occlusion of a pixel by its surroundings as balls",
         .formula =
             "(intensity times the sum of 2 rho_i M C(p, s_i), n), M the pixels of the disc, rho_i uniform",
         .source = "Shanmugam and Arikan 2007, CS-H"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_proxy_gather(position, normal, camera, kernel, method,
                                                 reference::SphereProxyMethod<T>{}, depth_of<T>(images));
        },
        {.domain = gather_domain(),
         .budget = {.absolute = 1.5e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(depth_prototype)}));
}

}  // namespace

void append_ray_gathers(Entries& entries) {
    append_disc(entries);
    append_march(entries);
    append_rays(entries);
    append_proxies(entries);
}

}  // namespace gloam::catalogue
