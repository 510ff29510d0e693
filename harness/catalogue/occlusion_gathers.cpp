// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/geometry/height_at.hpp"
#include "reference/methods/disc.hpp"
#include "reference/methods/hemisphere.hpp"
#include "reference/methods/volumetric.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera<float>;
using Kernel = reference::GloamKernel<float>;
using Method = reference::GloamMethod<float>;
using reference::GloamCamera;
using reference::GloamKernel;
using reference::GloamMethod;
using reference::mat3;
using reference::vec2;
using reference::vec3;

constexpr const char* prototype = depth_prototype;
constexpr const char* hemisphere_file = "passes/methods/hemisphere.glsl";
constexpr const char* disc_file = "passes/methods/disc.glsl";
constexpr double most_samples = 64;

// A sample near the border of two pixels, or near the depth at which it is blocked, may fall to either side:
// its whole contribution then differs. Moving the inputs by a few ULP must account for it.
constexpr Budget hemisphere_budget{.backward_ulp = 4};
constexpr Budget contribution_budget{.absolute = 1e-6, .backward_ulp = 4};
constexpr Budget disc_budget{.absolute = 4e-6, .backward_ulp = 4};

// Orthonormal frames, random ones and some that are none.
Values frames() {
    return made_by<glm::mat3>([](numeric::Random& random) {
               const glm::dvec3 n(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
               return glm::mat3(reference::gloam_tangent_frame(n));
           })
        .and_special();
}
void append_can_gather(Entries& entries) {
    const Values vectors = vector(3, uniform(-4, 4)).and_special();
    entries.push_back(equation<bool(glm::vec3, glm::vec3, float)>(
        {.id = "TSSAO-2-can",
         .function = "gloam_can_gather",
         .file = "gloam/occlusion/gather_kernel.glsl",
         .title = "whether there is anything to gather at a point",
         .formula = "surface in front of the eye, normal not zero, 0 < R < infinity",
         .source = "edges of TSSAO (Mattausch et al.), eq 2"},
        GLOAM_REFERENCE(gloam_can_gather), {.domain = {vectors, vectors, gather_length()}}));
}

void append_tap(Entries& entries) {
    using Tap = glm::vec2(glm::vec2, glm::vec3, glm::mat3, Camera, Kernel, Method, glm::vec3);
    const Values point = vector({uniform(-0.6, 0.6), uniform(-0.6, 0.6), uniform(0, 0.5)})
                             .and_value(glm::vec3(0), true)
                             .and_special();
    entries.push_back(equation<Tap>(
        {
            .id = "TSSAO-3-hemisphere",
            .function = "gloam_point_tap",
            .file = hemisphere_file,
            .title = "one point of the half ball against the depth buffer",
            .formula = "(sum + V(p, s), n + 1)",
            .source = "TSSAO (Mattausch et al.), eq 3",
        },
        []<class T>(const ImageSet& images, vec2<T> accumulated, vec3<T> position, const mat3<T>& frame,
                    const GloamCamera<T>& camera, const GloamKernel<T>& kernel, const GloamMethod<T>& method,
                    vec3<T> point) {
            return reference::gloam_point_tap(accumulated, position, frame, camera, kernel, method, point,
                                              reference::HemisphereMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{constant(glm::vec2(3, 7)), gather_positions(), frames(), cameras(),
                          gather_kernels(), gather_methods(), point}
                       .adjusted(place_before_camera(2, 14)),
         .budget = hemisphere_budget,
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Tap>([](glm::vec2, const glm::vec3& p, const glm::mat3& frame, const Camera& c,
                                    const Kernel& k, const Method& m, const glm::vec3& s) {
                 return moderate(1e-9, 4, frame) && moderate(1e-9, 4, s) &&
                        usual_gather(p, glm::vec3(0), c, k, m);
             }),
         .scenarios = depth_scenarios(prototype)}));
}

void append_hemisphere(Entries& entries) {
    using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Kernel, Method);
    entries.push_back(equation<Gather>(
        {.id = "TSSAO-2-hemisphere",
         .function = "gloam_point_gather",
         .file = hemisphere_file,
         .title = "occlusion of a pixel by points of the half ball",
         .formula = "(sum of V(p, s_i), n), s_i of TSSAO-14, i = j + 1 ... j + k",
         .source = "TSSAO (Mattausch et al.), eqs 2 to 4 and 14; Ritschel et al. 2009"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_point_gather(position, normal, camera, kernel, method,
                                                 reference::HemisphereMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          gather_methods()}
                       .adjusted(place_before_camera(0, 6)),
         .budget = hemisphere_budget,
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(prototype)}));
}

void append_tap_pixel(Entries& entries) {
    const Values distance = either(constant(0.0F), log_uniform(1, 64)).and_special();
    const Values pixel = vector({integers(0, 2000), integers(0, 1000)});
    entries.push_back(equation<glm::ivec2(glm::ivec2, glm::ivec2, glm::ivec2, float)>(
        {.id = "TAP-pixel",
         .function = "gloam_tap_pixel",
         .file = "gloam/sampling/tap_pixel.glsl",
         .title = "pixel whose depth a tap reads",
         .formula = "the pixel that the depth chain's texel stands for, of the level for the tap's distance",
         .source = "SAO (McGuire et al. 2012)"},
        GLOAM_REFERENCE(gloam_tap_pixel),
        {.domain = {pixel, pixel, constant(glm::ivec2(2001, 1001)), distance}}));
}

void append_disc(Entries& entries) {
    using Contribution = float(glm::vec3, glm::vec3, glm::ivec2, Camera, Kernel, Method);
    using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Kernel, Method);
    entries.push_back(equation<Contribution>(
        {.id = "TSSAO-12-disc",
         .function = "gloam_tap_at",
         .file = disc_file,
         .title = "contribution of the surface at a tap",
         .formula = "epsilon C(p, s), s the surface under the pixel, |s - p| <= R, (s - p) . n > bias",
         .source = "TSSAO (Mattausch et al.), eqs 12 and 13"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, glm::ivec2 at,
                    const GloamCamera<T>& camera, const GloamKernel<T>& kernel,
                    const GloamMethod<T>& method) {
            return reference::gloam_tap_at(position, normal, at, camera, kernel, method,
                                           reference::DiscMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), image_pixel(), cameras(),
                          gather_kernels(), gather_methods()}
                       .adjusted(place_before_camera(0, 8)),
         .budget = contribution_budget,
         .codomain = {0, 1},
         .promised = make_predicate<Contribution>(
             [](const glm::vec3& p, const glm::vec3& n, glm::ivec2, const Camera& c, const Kernel& k,
                const Method& m) { return usual_gather(p, n, c, k, m); }),
         .scenarios = depth_scenarios(prototype)}));
    entries.push_back(equation<Gather>(
        {.id = "TSSAO-2-disc",
         .function = "gloam_tap_gather",
         .file = disc_file,
         .title = "crease shading of a pixel by surface points under a disc",
         .formula = "(sum of epsilon C(p, s_i), n), s_i under TSSAO-13, i = j + 1 ... j + k",
         .source = "TSSAO (Mattausch et al.), eqs 2, 4, 12 and 13; Fox and Compton 2008"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_tap_gather(position, normal, camera, kernel, method,
                                               reference::DiscMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          gather_methods()}
                       .adjusted(place_before_camera(0, 6)),
         .budget = disc_budget,
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(prototype)}));
}

void append_pairs(Entries& entries) {
    using Offset = glm::vec3(glm::vec3, glm::ivec2, Camera, float);
    constexpr const char* file = "passes/methods/volumetric.glsl";
    entries.push_back(equation<Offset>(
        {.id = "PAIR-offset",
         .function = "gloam_pair_offset",
         .file = file,
         .title = "from a point to the surface at a tap",
         .formula = "s - p; background 10^4 radii behind",
         .source = "definition"},
        []<class T>(const ImageSet& images, vec3<T> position, glm::ivec2 at, const GloamCamera<T>& camera,
                    T radius) {
            return reference::gloam_pair_offset(position, at, camera, radius, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), image_pixel(), cameras(), gather_length()}.adjusted(
             place_before_camera(0, 5)),
         .budget = {.ulp = 8, .absolute = 4e-6, .of_largest_component = true},
         .codomain = {-3.5e38, 3.5e38},
         .promised =
             make_predicate<Offset>([](const glm::vec3& p, glm::ivec2, const Camera& c, float radius) {
                 return moderate(1e-9, 1e9, p, c.p00_p11, radius);
             }),
         .scenarios = depth_scenarios(prototype)}));
    using Height = float(glm::vec3, glm::vec3, glm::vec3, glm::vec3);
    const Values offset = vector(3, uniform(-4, 4)).and_special();
    entries.push_back(equation<Height>(
        {.id = "PAIR-height",
         .function = "gloam_height_at",
         .file = "gloam/geometry/height_at.glsl",
         .title = "height of the surface of a tap at the aimed place",
         .formula = "((s - p - a) . n) / (v . n)",
         .source = "definition"},
        GLOAM_REFERENCE(gloam_height_at),
        {.domain = {offset, offset, unit_vector(3).and_special(), unit_vector(3).and_special()},
         .budget = {.absolute = 3e-4},
         .codomain = {-3.5e38, 3.5e38},
         .promised = make_predicate<Height>(
             [](const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& view, const glm::dvec3& n) {
                 return moderate(1e-9, 8, v, a) && moderate(1e-9, 1, view, n) && glm::dot(view, n) > 0.03 &&
                        !(glm::dot(v, v) + glm::dot(a, a) > 1e4);
             })}));
}

void append_pair_gather(Entries& entries) {
    using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Kernel, Method);
    constexpr const char* file = "passes/methods/volumetric.glsl";
    entries.push_back(equation<unsigned(unsigned)>(
        {.id = "PAIR-samples",
         .function = "gloam_paired_samples",
         .file = file,
         .title = "samples of whole pairs",
         .formula = "2 ceil(k / 2)",
         .source = "definition"},
        GLOAM_REFERENCE(gloam_paired_samples),
        {.domain = {log_integers(100'000)}, .scenarios = depth_scenarios(prototype)}));
    entries.push_back(equation<Gather>(
        {.id = "CS-I-gather",
         .function = "gloam_pair_gather",
         .file = file,
         .title = "solid share of the ball around a pixel, by paired lines",
         .formula = "n times the mean of q_i weighted by h_i, n",
         .source = "volumetric obscurance (Loos and Sloan 2010), CS-3.5"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_pair_gather(position, normal, camera, kernel, method,
                                                reference::VolumetricMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          gather_methods()}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 1.5e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(prototype)}));
}

}  // namespace

void append_gathers(Entries& entries) {
    append_can_gather(entries);
    append_tap(entries);
    append_hemisphere(entries);
    append_tap_pixel(entries);
    append_disc(entries);
    append_pairs(entries);
    append_pair_gather(entries);
}

}  // namespace gloam::catalogue
