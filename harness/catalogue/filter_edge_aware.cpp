// SPDX-License-Identifier: MIT
#include <limits>

#include "catalogue/filter_parts.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* occlusion_name = "gloam_fetch_occlusion";
constexpr const char* normal_name = "gloam_fetch_normal";
constexpr const char* depth_name = "gloam_fetch_depth";

auto scalars_of(const ImageSet& images, const char* name) {
    return [&images, name](glm::ivec2 pixel) { return images.at(name).at<double>(pixel); };
}

float occlusion_or_worse(numeric::Random& random) {
    constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                             -0.25F, 1.5F};
    return random.below(32) == 0 ? bad[random.below(4)] : static_cast<float>(random.unit());
}

// Noisy occlusion on a slanted surface with a step and holes of background.
ImageSet noisy_surface(glm::ivec2 size, numeric::Random& random) {
    const auto depth = [&](glm::ivec2 pixel) {
        if (random.below(16) == 0)
            return random.below(2) == 0 ? 0.0F : std::numeric_limits<float>::infinity();
        return ((pixel.x + pixel.y) % 7 < 4 ? 2.0F : 3.0F) + 0.005F * static_cast<float>(pixel.x);
    };
    const auto normal = [&](glm::ivec2) {
        if (random.below(16) == 0) return glm::vec3(0);
        return glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
    };
    ImageSet images;
    images.emplace(normal_name, make_image<glm::vec3>(size, normal));
    images.emplace(occlusion_name,
                   make_image<float>(size, [&](glm::ivec2) { return occlusion_or_worse(random); }));
    images.emplace(depth_name, make_image<float>(size, depth));
    return images;
}

std::vector<ImageScenario> surfaces() {
    return image_scenarios(noisy_surface);
}

void append_bilateral(Entries& entries) {
    constexpr const char* source = "ISSAO, eq 7; Tomasi and Manduchi 1998";
    const Values pixels = either(uniform(0.5, 4), log_uniform(1e-30, 1e30)).and_special();
    const Values lengths = either(log_uniform(0.01, 2), log_uniform(1e-30, 1e30)).and_special();
    entries.push_back(equation<float(glm::vec2, float, float, float)>(
        {.id = "ISSAO-7-weight",
         .function = "gloam_bilateral_weight",
         .file = "gloam/filter/bilateral_weight.glsl",
         .title = "weight of a neighbour by distance and depth",
         .formula = "exp(-(|xi - x| / sigma_d)^2 / 2) exp(-((dp(xi) - dp(x)) / sigma_r)^2 / 2)",
         .source = source},
        &reference::gloam_bilateral_weight,
        {.domain = {vector(2, uniform(-8, 8)).and_value(glm::vec2(0)),
                    either(uniform(-1, 1), signed_log_uniform(1e-37, 1e38)).and_special(), pixels, lengths},
         .budget = {.absolute = 4e-7},
         .codomain = {0, 1},
         .promised = make_predicate<float(glm::vec2, float, float, float)>(
             [](glm::dvec2 offset, double difference, double, double) {
                 return moderate(1e-15, 1e15, offset, difference);
             })}));
}

void append_bilateral_mean(Entries& entries) {
    constexpr const char* file = "gloam/filter/bilateral.glsl";
    constexpr const char* source = "ISSAO, eq 7; Tomasi and Manduchi 1998";
    using Mean = reference::GloamWeightedMean;
    using Tap = Mean(Mean, glm::ivec2, float, glm::ivec2, glm::ivec2, float, float);
    const Values sigma_d = uniform(0.5, 4).and_special();
    const Values sigma_r = log_uniform(0.01, 2).and_special();
    entries.push_back(equation<Tap>(
        {.id = "ISSAO-7-tap",
         .function = "gloam_bilateral_tap",
         .file = file,
         .title = "one neighbour in the bilateral mean",
         .formula = "(sum + g s f, k + g s)",
         .source = source},
        [](const ImageSet& images, const reference::GloamWeightedMean& mean, glm::ivec2 pixel, double center,
           glm::ivec2 tap, glm::ivec2 size, double sigma_pixels, double sigma_depth) {
            return reference::gloam_bilateral_tap(mean, pixel, center, tap, size, sigma_pixels, sigma_depth,
                                                  scalars_of(images, occlusion_name),
                                                  scalars_of(images, depth_name));
        },
        {.domain = {constant(glm::vec4(1, 2, 0.25, 0.75)).only_as_drawn(), image_pixel(), uniform(1.9, 3.1),
                    either(image_pixel(), vector(2, integers(-4, 4))), image_size().only_as_drawn(), sigma_d,
                    sigma_r},
         .budget = {.absolute = 6e-7},
         .codomain = {0, 3},
         .scenarios = surfaces()}));
    // Few taps, because the number of paths of an interval grows with every tap.
    const Values half_width = either(vector(2, integers(0, 1)), vector({integers(0, 3), integers(0, 0)}))
                                  .and_value(glm::ivec2(0, -5));
    entries.push_back(equation<float(glm::ivec2, glm::ivec2, glm::ivec2, float, float)>(
        {.id = "ISSAO-7",
         .function = "gloam_bilateral_filter",
         .file = file,
         .title = "bilateral smoothing of occlusion",
         .formula = "(1 / k) sum of f(xi) g(xi, x) s(dp(xi), dp(x)), k the sum of g s",
         .source = source},
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 half, glm::ivec2 size, double sigma_d,
           double sigma_r) {
            return reference::gloam_bilateral_filter(pixel, half, size, sigma_d, sigma_r,
                                                     scalars_of(images, occlusion_name),
                                                     scalars_of(images, depth_name));
        },
        {.domain = {image_pixel(), half_width, image_size(), sigma_d, sigma_r},
         .budget = {.absolute = 6e-7},
         .codomain = {0, 1},
         .scenarios = surfaces()}));
}

auto normals_of(const ImageSet& images) {
    return [&images](glm::ivec2 pixel) { return images.at(normal_name).at<glm::dvec3>(pixel); };
}

constexpr const char* blur_source = "Aalund and Baerentzen 2013, geometry-aware blur";
constexpr const char* blur_file = "gloam/filter/geometry_blur.glsl";

void append_geometry_weight(Entries& entries) {
    using Weight = float(glm::vec3, glm::vec3, float, float, float);
    entries.push_back(equation<Weight>(
        {.id = "CS-BLUR-weight",
         .function = "gloam_geometry_weight",
         .file = "gloam/filter/geometry_weight.glsl",
         .title = "weight of a neighbour by normal and depth",
         .formula = "(n_0 . n_i / 2 + 1/2)^p_n (1 + |z_0 - z_i|)^-p_z",
         .source = blur_source},
        &reference::gloam_geometry_weight,
        {.domain = {unit_vector(3).and_value(glm::vec3(0)).and_special(),
                    unit_vector(3).and_value(glm::vec3(0)),
                    either(uniform(-4, 4), signed_log_uniform(1e-30, 1e30)).and_special(),
                    uniform(1, 16).and_near({10.0}).and_special(),
                    uniform(0, 2).and_near({0.0, 0.5}).and_special()},
         .budget = {.absolute = 3e-6},
         .codomain = {0, 1},
         .promised =
             make_predicate<Weight>([](glm::dvec3 n, glm::dvec3, double, double by_normal, double by_depth) {
                 return moderate(1e-9, 1.1, n) && by_normal >= 1 && by_normal <= 17 && by_depth <= 3;
             })}));
}

void append_geometry_blur(Entries& entries) {
    using Mean = reference::GloamWeightedMean;
    using Tap = Mean(Mean, float, glm::vec3, glm::ivec2, glm::ivec2, glm::vec2);
    const Values powers = vector({uniform(1, 16), uniform(0, 1)});
    entries.push_back(equation<Tap>(
        {.id = "CS-BLUR-tap",
         .function = "gloam_geometry_blur_tap",
         .file = blur_file,
         .title = "one neighbour in the geometry-aware blur",
         .formula = "(sum + w AO, K + w)",
         .source = blur_source},
        [](const ImageSet& images, const reference::GloamWeightedMean& mean, double center, glm::dvec3 normal,
           glm::ivec2 tap, glm::ivec2 size, glm::dvec2 exponents) {
            return reference::gloam_geometry_blur_tap(mean, center, normal, tap, size, exponents,
                                                      scalars_of(images, occlusion_name),
                                                      scalars_of(images, depth_name), normals_of(images));
        },
        {.domain = {constant(glm::vec4(1, 2, 0.25, 0.75)).only_as_drawn(), uniform(1.9, 3.1),
                    vector({uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(0.6, 0.8)}),
                    either(image_pixel(), vector(2, integers(-4, 4))), image_size().only_as_drawn(), powers},
         .budget = {.absolute = 2e-6},
         .codomain = {0, 3},
         .scenarios = surfaces()}));
    const Values axis = made_by<glm::ivec2>(
        [](numeric::Random& random) { return random.below(2) == 0 ? glm::ivec2(1, 0) : glm::ivec2(0, 1); });
    entries.push_back(equation<float(glm::ivec2, glm::ivec2, glm::ivec2, int, glm::vec2)>(
        {.id = "CS-BLUR",
         .function = "gloam_geometry_blur",
         .file = blur_file,
         .title = "geometry-aware blur along one axis",
         .formula = "(1 / K) sum of w AO, K the sum of w",
         .source = blur_source},
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 along, glm::ivec2 size, int half_width,
           glm::dvec2 exponents) {
            return reference::gloam_geometry_blur(pixel, along, size, half_width, exponents,
                                                  scalars_of(images, occlusion_name),
                                                  scalars_of(images, depth_name), normals_of(images));
        },
        {.domain = {image_pixel(), axis, image_size().only_as_drawn(), integers(0, 4).and_near_integers({0}),
                    powers},
         .budget = {.absolute = 1e-6},
         .codomain = {0, 1},
         .scenarios = surfaces()}));
}

}  // namespace

void append_edge_aware(Entries& entries) {
    append_bilateral(entries);
    append_bilateral_mean(entries);
    append_geometry_weight(entries);
    append_geometry_blur(entries);
}

}  // namespace gloam::catalogue
