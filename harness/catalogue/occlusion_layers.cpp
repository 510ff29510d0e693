// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* curvature_file = "gloam/occlusion/curvature.glsl";
constexpr const char* hattori = "derived, after Hattori et al. 2012";
constexpr const char* bavoil = "Bavoil and Sainz 2009";
constexpr const char* huang = "Huang et al. 2011 (separable AO)";

void append_curvature(Entries& entries) {
    const Values slope = either(uniform(0, 4), log_uniform(1e-4, 4096));
    using Parts = float(float, float);
    entries.push_back(
        equation<Parts>({.id = "CS-K-bowl",
                         .function = "gloam_occlusion_bowl",
                         .file = curvature_file,
                         .title = "occlusion in a bowl",
                         .formula = "1 - Re 1 / sqrt((1 + i a) (1 + i b))",
                         .source = hattori},
                        &reference::gloam_occlusion_bowl,
                        {.domain = {slope, slope}, .budget = {.absolute = 4e-7}, .codomain = {0, 1}}));
    const Values falling =
        made_by<float>([](numeric::Random& random) { return -std::exp(random.uniform(-9.2, 8.3)); });
    entries.push_back(equation<Parts>(
        {.id = "CS-K-saddle",
         .function = "gloam_occlusion_saddle",
         .file = curvature_file,
         .title = "occlusion on a saddle",
         .formula = "(2 / pi) (phi_0 - Re atan(t sqrt(B / A)) / sqrt(A B)), t = tan phi_0 = sqrt(-a / b)",
         .source = hattori},
        &reference::gloam_occlusion_saddle,
        {.domain = {slope, falling}, .budget = {.absolute = 8e-7}, .codomain = {0, 1}}));
    const Values curvature =
        either(signed_log_uniform(1e-3, 100), any_float()).and_near({0.0, 2.0}).and_special();
    using Whole = float(float, float, float);
    entries.push_back(equation<Whole>(
        {.id = "CS-K",
         .function = "gloam_occlusion_curvature",
         .file = curvature_file,
         .title = "occlusion by principal curvatures",
         .formula = "mean over phi of q^2 / (1 + q^2), q = max(k_1 cos^2 phi + k_2 sin^2 phi, 0) R / 2",
         .source = hattori},
        &reference::gloam_occlusion_curvature,
        {.domain = {curvature, curvature,
                    either(log_uniform(0.1, 2), any_float()).and_near({1.0}).and_special()},
         .budget = {.absolute = 8e-7},
         .codomain = {0, 1},
         .promised = make_predicate<Whole>([](double a, double b, double radius) {
             return moderate(1e-18, 1e18, a, b, radius) && std::isfinite(radius);
         })}));
}

void append_tests_of_depth(Entries& entries) {
    const Values depth =
        either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, 0x1.fffffep127}).and_special();
    entries.push_back(equation<bool(float, float, float)>(
        {.id = "CS-REJ",
         .function = "gloam_tap_rejected",
         .file = "gloam/occlusion/depth_rejection.glsl",
         .title = "whether a tap lies too far in front",
         .formula = "d_p - d_s > threshold",
         .source = "Aalund and Baerentzen 2013"},
        &reference::gloam_tap_rejected,
        {.domain = {depth, depth, either(log_uniform(1e-3, 10), constant(1.0F)).and_special()},
         .budget = {.backward_ulp = 1}}));
    const Values plain = either(uniform(0.5, 8), uniform(-8, -0.5));
    const Values further = vector(3, plain);
    entries.push_back(equation<float(float, glm::vec3, int)>(
        {.id = "CS-LAYERS-depth",
         .function = "gloam_layer_depth",
         .file = "gloam/occlusion/layers.glsl",
         .title = "depth of a layer at a tap",
         .formula = "d_0, |d_1|, |d_2|, |d_3|",
         .source = bavoil},
        &reference::gloam_layer_depth, {.domain = {plain, further, integers(0, 3)}, .codomain = {-8, 8}}));
    using Seen = reference::GloamLayersSeen;
    entries.push_back(equation<Seen(Seen, float, glm::vec3, float, int, int)>(
        {.id = "CS-LAYERS-together",
         .function = "gloam_layers_add",
         .file = "gloam/occlusion/layers.glsl",
         .title = "what the layers at a sample point say together",
         .formula = "the largest of the layers; a back in front of the point takes what it closes away",
         .source = bavoil},
        &reference::gloam_layers_add,
        {.domain = {vector({uniform(0, 1), uniform(0, 1), booleans()}).only_as_drawn(), uniform(0, 1),
                    vector(3, plain), uniform(0.5, 8), integers(0, 3), integers(1, 4)},
         .codomain = {0, 1}}));
    entries.push_back(equation<float(float, float, float)>(
        {.id = "CS-LAYERS-blocked",
         .function = "gloam_layer_blocked",
         .file = "gloam/occlusion/layers.glsl",
         .title = "whether a sample lies between the front and the back of an object",
         .formula = "front <= d <= back",
         .source = bavoil},
        &reference::gloam_layer_blocked,
        {.domain = Domain{depth, depth, depth}.tied(0, 1).tied(0, 2), .codomain = {0, 1}}));
}

void append_means(Entries& entries) {
    const Values occlusion = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(equation<float(float, float)>({.id = "CS-LAYERS",
                                                     .function = "gloam_layers_occlusion",
                                                     .file = "gloam/occlusion/layers.glsl",
                                                     .title = "occlusion over layers or views",
                                                     .formula = "max(occlusion, layer)",
                                                     .source = bavoil},
                                                    &reference::gloam_layers_occlusion,
                                                    {.domain = {occlusion, occlusion}, .codomain = {0, 1}}));
    constexpr const char* file = "gloam/occlusion/separable.glsl";
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-O",
         .function = "gloam_separable_mean",
         .file = file,
         .title = "occlusion of two directions",
         .formula = "(AO_u + AO_v) / 2",
         .source = huang},
        &reference::gloam_separable_mean,
        {.domain = {occlusion, occlusion}, .budget = {.ulp = 0.5}, .codomain = {0, 1}}));
    using Weight = float(glm::vec3, glm::vec3, float, float);
    const Values offset =
        either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-20, 1e20)))
            .and_value(glm::vec3(0))
            .and_special();
    const Values length = either(log_uniform(1e-2, 10), any_float()).and_special();
    entries.push_back(equation<Weight>(
        {.id = "CS-O-weight",
         .function = "gloam_separable_weight",
         .file = file,
         .title = "weight of a neighbour whose first-pass occlusion is taken over",
         .formula = "exp(-|q - p|^2 / (2 sigma^2)) if |(q - p) . n| <= tolerance, else 0",
         .source = huang},
        &reference::gloam_separable_weight,
        {.domain = {offset, unit_vector(3).and_special(), length, length},
         .budget = {.absolute = 5e-7, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised = make_predicate<Weight>([](glm::dvec3 v, glm::dvec3 n, double sigma, double tolerance) {
             return moderate(1e-9, 1e9, v, n, sigma, tolerance);
         })}));
}

}  // namespace

void append_occlusion_layers(Entries& entries) {
    append_curvature(entries);
    append_tests_of_depth(entries);
    append_means(entries);
}

}  // namespace gloam::catalogue
