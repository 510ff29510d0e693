// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/geometry.hpp"
#include "reference/methods.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera;
using Kernel = reference::GloamKernel;
using Estimate = reference::GloamEstimate;
using reference::GloamCamera;
using reference::GloamKernel;

constexpr double most_samples = 64;

// A sample near the border of two pixels, or near the depth at which it is blocked, may fall to either side.
// Then its whole contribution differs, so the budget must include inputs that are moved by a few ULP.
void append_can_gather(Entries& entries) {
    const Values vectors = vector(3, uniform(-4, 4)).and_special();
    entries.push_back(equation<bool(glm::vec3, glm::vec3, float, Camera)>(
        {.id = "TSSAO-2-can",
         .function = "gloam_can_gather",
         .file = "gloam/occlusion/gather_kernel.glsl",
         .title = "whether there is anything to gather at a point",
         .formula =
             "surface in front of the eye, |n| in [1e-15, 1e15], lengths and projection in [1e-18, 1e18]",
         .source = "edges of TSSAO (Mattausch et al.), eq 2"},
        &reference::gloam_can_gather, {.domain = {vectors, vectors, gather_length(), cameras()}}));
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
        &reference::gloam_tap_pixel, {.domain = {pixel, pixel, constant(glm::ivec2(2001, 1001)), distance}}));
}

void append_pairs(Entries& entries) {
    using Height = float(glm::vec3, glm::vec3, glm::vec3, glm::vec3);
    const Values offset = vector(3, uniform(-4, 4)).and_special();
    entries.push_back(equation<Height>(
        {.id = "PAIR-height",
         .function = "gloam_height_at",
         .file = "gloam/geometry/height_at.glsl",
         .title = "height of the surface of a tap at the aimed place",
         .formula = "((s - p - a) . n) / (v . n)",
         .source = "definition"},
        &reference::gloam_height_at,
        {.domain = {offset, offset, unit_vector(3).and_special(), unit_vector(3).and_special()},
         .budget = {.absolute = 3.5e-4},
         .codomain = {-3.5e38, 3.5e38},
         .promised = make_predicate<Height>(
             [](const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& view, const glm::dvec3& n) {
                 return moderate(1e-9, 8, v, a) && moderate(1e-9, 1, view, n) && glm::dot(view, n) > 0.03 &&
                        !(glm::dot(v, v) + glm::dot(a, a) > 1e4);
             })}));
}

void append_hemisphere(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamHemisphere);
    entries.push_back(equation<Signature>(
        {.id = "TSSAO-2-hemisphere",
         .function = "gloam_hemisphere",
         .file = "gloam/methods/hemisphere.glsl",
         .title = "occlusion of a pixel by points of the half ball",
         .formula = "mean of V(p, s_i), s_i of TSSAO-14, i = j + 1 ... j + k",
         .source = "TSSAO (Mattausch et al.), eqs 2 to 4 and 14; Ritschel et al. 2009"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamHemisphere& own) {
            return reference::gloam_hemisphere(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({gather_length()})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.ulp = 1, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                          const Kernel& k, const auto&) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

void append_disc(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamDisc);
    entries.push_back(equation<Signature>(
        {.id = "TSSAO-2-disc",
         .function = "gloam_disc",
         .file = "gloam/methods/disc.glsl",
         .title = "crease shading of a pixel by surface points under a disc",
         .formula = "mean of epsilon C(p, s_i), s_i under TSSAO-13, i = j + 1 ... j + k",
         .source = "TSSAO (Mattausch et al.), eqs 2, 4, 12 and 13; Fox and Compton 2008"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamDisc& own) {
            return reference::gloam_disc(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({gather_length()})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 2e-6, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                          const Kernel& k, const auto&) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

void append_volumetric(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel);
    entries.push_back(equation<Signature>(
        {.id = "CS-I-gather",
         .function = "gloam_volumetric",
         .file = "gloam/methods/volumetric.glsl",
         .title = "solid share of the ball around a pixel, by paired lines",
         .formula = "mean of q_i weighted by h_i",
         .source = "volumetric obscurance (Loos and Sloan 2010), CS-3.5"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel) {
            return reference::gloam_volumetric(position, normal, camera, kernel, layers_of(images));
        },
        {.domain =
             Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels()}.adjusted(
                 place_before_camera(0, 6)),
         .budget = {.absolute = 2e-6, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                                  const Kernel& k) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

void append_estimates(Entries& entries) {
    const Values sum = either(uniform(0, 64), log_uniform(1e-37, 1e30)).and_special();
    entries.push_back(equation<Estimate(float, float, unsigned)>(
        {.id = "TSSAO-2-estimate",
         .function = "gloam_estimate",
         .file = "gloam/occlusion/gather_kernel.glsl",
         .title = "estimate of a weighted mean",
         .formula = "min(sum / weight, 1)",
         .source = "TSSAO (Mattausch et al.), eq 2"},
        &reference::gloam_estimate,
        {.domain = {sum, sum, integers(0, 2048)},
         .budget = {.ulp = 0.5},
         .codomain = {0, 2048},
         .promised =
             make_predicate<Estimate(float, float, unsigned)>([](double occluded, double whole, unsigned) {
                 return !(whole > 8.5e37) && moderate(1e-30, 3e37, occluded);
             })}));
    entries.push_back(
        equation<bool(float)>({.id = "TSSAO-2-sees",
                               .function = "gloam_tap_sees",
                               .file = "gloam/occlusion/gather_kernel.glsl",
                               .title = "whether a depth is that of a surface",
                               .formula = "1e-18 <= d <= 1e18",
                               .source = "definition"},
                              &reference::gloam_tap_sees,
                              {.domain = {either(log_uniform(1e-37, 1e38), any_float()).and_special()}}));
    entries.push_back(equation<unsigned(unsigned)>({.id = "PAIR-samples",
                                                    .function = "gloam_paired_samples",
                                                    .file = "gloam/sampling/whole_samples.glsl",
                                                    .title = "samples of whole pairs",
                                                    .formula = "2 ceil(k / 2)",
                                                    .source = "definition"},
                                                   &reference::gloam_paired_samples,
                                                   {.domain = {log_integers(100'000)}}));
}

// The parts of the samples that all pixels share.
void append_shared_points(Entries& entries) {
    const auto add = [&](const char* id, const char* name, const char* formula, auto reference,
                         double absolute, double most_third = 1.0) {
        entries.push_back(equation<glm::vec3(unsigned)>(
            {.id = id,
             .function = std::string("gloam_") + name + "_point",
             .file = std::string("gloam/sampling/") + name + "_point.glsl",
             .title = std::string("point of a sample: ") + name,
             .formula = formula,
             .source = "TSSAO (Mattausch et al.), eqs 13 and 14"},
            reference,
            {.domain = {log_integers(16777216).and_near_integers({16777216, 4294967295})},
             .budget = {.absolute = absolute},
             .codomain = {-1.000001, 1.000001},
             .promised = make_predicate<glm::vec3(unsigned)>([most_third](unsigned index) {
                 return reference::gloam_radical_inverse(index, 5U) < most_third;
             })}));
    };
    add("POINTS-halton", "halton", "HALTON in bases 2, 3, 5", &reference::gloam_halton_point, 2e-7);
    add("POINTS-disc", "disc", "TSSAO-13 of the Halton point", &reference::gloam_disc_point, 5e-7);
    add("POINTS-hemisphere-cosine", "hemisphere_cosine", "TSSAO-14 of the Halton point",
        &reference::gloam_hemisphere_cosine_point, 1.2e-6, 0.998);
    add("POINTS-hemisphere-uniform", "hemisphere_uniform", "TSSAO-14-uniform of the Halton point",
        &reference::gloam_hemisphere_uniform_point, 2e-6, 0.998);
}

}  // namespace

void append_gathers(Entries& entries) {
    append_can_gather(entries);
    append_estimates(entries);
    append_shared_points(entries);
    append_hemisphere(entries);
    append_tap_pixel(entries);
    append_disc(entries);
    append_pairs(entries);
    append_volumetric(entries);
}

}  // namespace gloam::catalogue
