// SPDX-License-Identifier: MIT
#include <limits>

#include "catalogue/filter_parts.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Mean = reference::GloamWeightedMean;

constexpr double float_max = 0x1.fffffep127;
constexpr double infinity = std::numeric_limits<double>::infinity();

Values lengths() {
    return either(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38))
        .and_near({0x1p-126, float_max})
        .and_special();
}

void append_shrink(Entries& entries) {
    const Values convergence = either(uniform(0, 1.1), log_uniform(1e-30, 1)).and_special();
    const Values threshold =
        either(uniform(0, 1), log_uniform(1e-37, 1e38)).and_near({0.2, 0x1p-126}).and_special();
    entries.push_back(
        equation<float(float, float)>({.id = "TSSAO-11",
                                       .function = "gloam_shrink",
                                       .file = "gloam/filter/shrink.glsl",
                                       .title = "factor on the filter's support",
                                       .formula = "s = max(c - conv, 0) / c",
                                       .source = "TSSAO (Mattausch et al.), eq 11"},
                                      &reference::gloam_shrink,
                                      {.domain = Domain{convergence, threshold}.tied(0, 1).tied(0, 1, 0.5),
                                       .budget = {.ulp = 1.5},
                                       .codomain = {0, 1}}));
}

void append_gaussian(Entries& entries) {
    constexpr const char* file = "gloam/filter/gaussian.glsl";
    constexpr const char* source = "TSSAO (Mattausch et al.), eq 10";
    const Values squares = either(uniform(0, 1), lengths()).and_near({99.5}).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "TSSAO-10-g",
         .function = "gloam_gaussian",
         .file = file,
         .title = "weight of a neighbour by its distance in the world",
         .formula = "g = exp(-d^2 / (2 sigma^2))",
         .source = source},
        &reference::gloam_gaussian,
        {.domain = {squares, lengths()}, .budget = {.absolute = 3e-7}, .codomain = {0, 1}}));
    entries.push_back(equation<float(float)>(
        {.id = "TSSAO-10-g-scale",
         .function = "gloam_gaussian_scale",
         .file = file,
         .title = "scale of distances for the Gaussian",
         .formula = "s = sqrt(log2(e) / 2) / sigma",
         .source = source},
        &reference::gloam_gaussian_scale,
        {.domain = {lengths().and_near({0x1p100})}, .budget = {.ulp = 1.5}, .codomain = {0, infinity}}));
    entries.push_back(equation<float(float, float)>(
        {.id = "TSSAO-10-g-scaled",
         .function = "gloam_gaussian_scaled",
         .file = file,
         .title = "weight of a neighbour by the scale of the Gaussian",
         .formula = "g = 2^-(d s)^2",
         .source = source},
        &reference::gloam_gaussian_scaled,
        {.domain = {squares, lengths()}, .budget = {.absolute = 3e-7}, .codomain = {0, 1}}));
}

void append_sigma(Entries& entries) {
    entries.push_back(equation<float(float, float, float, float)>(
        {.id = "TSSAO-10-sigma",
         .function = "gloam_filter_sigma",
         .file = "gloam/filter/gaussian.glsl",
         .title = "width of the filter in the world",
         .formula = "sigma = sigma_px 2 d tan(fov_y / 2) / H",
         .source = "derived: world size of a pixel"},
        &reference::gloam_filter_sigma,
        {.domain = {log_uniform(1e-3, 1e6).and_special(), uniform(0.1, 2).and_special(),
                    log_uniform(1, 16384).and_special(), uniform(0.25, 8).and_special()},
         .budget = {.ulp = 2.5},
         .codomain = {0, float_max},
         .promised = make_predicate<float(float, float, float, float)>(
             [](double d, double tangent, double height, double pixels) {
                 return moderate(1e-9, 1e9, d, tangent, height, pixels);
             })}));
}

void append_mean(Entries& entries) {
    constexpr const char* file = "gloam/filter/weighted_mean.glsl";
    constexpr const char* source = "TSSAO (Mattausch et al.), the quotient of eq 10";
    const Values value = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    const Values weight = either(uniform(0, 1), log_uniform(1e-12, 1)).and_special();
    // Sums of a few values: (sum, weight, low, high) with low <= sum / weight <= high.
    const Values mean = made_by<glm::vec4>([](numeric::Random& random) {
                            const double low = random.unit();
                            const double high = random.uniform(low, 1);
                            const double weight =
                                random.below(4) == 0 ? random.uniform(0, 3e-8) : random.uniform(0, 5);
                            return glm::vec4(random.uniform(low, high) * weight, weight, low, high);
                        }).only_as_drawn();
    entries.push_back(equation<Mean()>({.id = "TSSAO-10-empty",
                                        .function = "gloam_weighted_mean_empty",
                                        .file = file,
                                        .title = "weighted mean of nothing",
                                        .formula = "(0, 0)",
                                        .source = source},
                                       &reference::gloam_weighted_mean_empty,
                                       {.domain = {}, .codomain = {0, 1}}));
    entries.push_back(equation<Mean(Mean, float, float)>(
        {.id = "TSSAO-10-add",
         .function = "gloam_weighted_mean_add",
         .file = file,
         .title = "one more value in a weighted mean",
         .formula = "(sum + w AO, K + w)",
         .source = source},
        &reference::gloam_weighted_mean_add,
        {.domain = {mean, value, weight}, .budget = {.ulp = 1.5}, .codomain = {0, float_max}}));
    entries.push_back(equation<float(Mean, float)>(
        {.id = "TSSAO-10-mean",
         .function = "gloam_weighted_mean_value",
         .file = file,
         .title = "weighted mean, or what stands in for it",
         .formula = "sum / K, the fallback for K < 1e-8",
         .source = source},
        &reference::gloam_weighted_mean_value,
        {.domain = {mean.and_value(glm::vec4(0.5E-8F, 1e-8F, 0, 1), true), value},
         .budget = {.ulp = 0.5, .backward_ulp = 1},
         .codomain = {0, 1}}));
}

constexpr const char* values_name = "gloam_fetch_occlusion_convergence";
constexpr const char* positions_name = "gloam_fetch_position";
constexpr const char* filter_file = "gloam/filter/convergence_filter.glsl";

auto values_of(const ImageSet& images) {
    return [&images](glm::ivec2 pixel) { return images.at(values_name).at<glm::dvec2>(pixel); };
}
auto positions_of(const ImageSet& images) {
    return [&images](glm::ivec2 pixel) { return images.at(positions_name).at<glm::dvec3>(pixel); };
}

float occlusion_or_worse(numeric::Random& random) {
    constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                             -0.25F, 1.5F};
    return random.below(32) == 0 ? bad[random.below(4)] : static_cast<float>(random.unit());
}

// Noisy occlusion, mostly unconverged, on a slanted surface with a step and background; some texels hold
// invalid values.
ImageSet noisy_surface(glm::ivec2 size, numeric::Random& random) {
    const auto value = [&](glm::ivec2) {
        const float convergence = random.below(3) == 0 ? 0.0F : occlusion_or_worse(random);
        return glm::vec2(occlusion_or_worse(random), convergence);
    };
    const auto position = [&](glm::ivec2 pixel) {
        if (random.below(16) == 0)
            return random.below(2) == 0 ? glm::vec3(0)
                                        : glm::vec3(0, 0, -std::numeric_limits<float>::infinity());
        const float depth = (pixel.x + pixel.y) % 7 < 4 ? 2.0F : 3.0F;
        return glm::vec3(0.01F * static_cast<float>(pixel.x), 0.01F * static_cast<float>(pixel.y),
                         -depth - 0.005F * static_cast<float>(pixel.x));
    };
    ImageSet images;
    images.emplace(values_name, make_image<glm::vec2>(size, value));
    images.emplace(positions_name, make_image<glm::vec3>(size, position));
    return images;
}

ImageSet no_surface(glm::ivec2 size, numeric::Random& random) {
    ImageSet images = noisy_surface(size, random);
    images[positions_name] = make_image<glm::vec3>(size, [](glm::ivec2) { return glm::vec3(0); });
    return images;
}

std::vector<ImageScenario> surfaces() {
    auto scenarios = image_scenarios(noisy_surface);
    scenarios.push_back({.name = "all background", .size = {5, 4}, .make = no_surface});
    return scenarios;
}

Values sigmas() {
    return either(log_uniform(0.003, 0.3), log_uniform(1e-6, 1e6)).and_special();
}
Values scales() {
    return either(log_uniform(3, 300), log_uniform(1e-6, 1e6)).and_special();
}

void append_window(Entries& entries) {
    entries.push_back(equation<float(int, float)>(
        {.id = "TSSAO-11-window",
         .function = "gloam_window_coverage",
         .file = "gloam/filter/shrink.glsl",
         .title = "how much of a pixel lies in the filter's window",
         .formula = "clamp(reach + 1 - |i|, 0, 1)",
         .source = "derived: overlap of a pixel with a window of half width reach + 1/2"},
        &reference::gloam_window_coverage,
        {.domain = {integers(1, 8).and_near_integers({16777216}),
                    uniform(0, 8).and_near({1.0, 2.0}).and_special()},
         .codomain = {0, 1},
         .promised = make_predicate<float(int, float)>(
             [](int offset, double reach) { return offset < 16 && !(reach > 16 && reach < 1e30); })}));
}

void append_filtering(Entries& entries) {
    using Tap = Mean(Mean, glm::vec3, glm::ivec2, float, float);
    entries.push_back(equation<Tap>(
        {.id = "TSSAO-10-tap",
         .function = "gloam_filter_tap",
         .file = filter_file,
         .title = "one neighbour in the filter's mean",
         .formula = "(sum + w AO, K + w), w = coverage g(|p - x|) conv(x)",
         .source = "TSSAO (Mattausch et al.), eq 10"},
        [](const ImageSet& images, const reference::GloamWeightedMean& mean, glm::dvec3 center,
           glm::ivec2 tap, double coverage, double scale) {
            return reference::gloam_filter_tap(mean, center, tap, coverage, scale, values_of(images),
                                               positions_of(images));
        },
        {.domain = {constant(glm::vec4(1, 2, 0.25, 0.75)).only_as_drawn(),
                    vector({uniform(0, 0.4), uniform(0, 0.4), uniform(-3, -2)}), image_pixel(), uniform(0, 1),
                    scales()},
         .budget = {.absolute = 5e-7},
         .codomain = {0, 6},
         .promised = make_predicate<Tap>([](const Mean&, glm::dvec3, glm::ivec2, double coverage, double) {
             return moderate(1e-30, 1.0, coverage);
         }),
         .scenarios = surfaces()}));
    const Values axis = made_by<glm::ivec2>(
        [](numeric::Random& random) { return random.below(2) == 0 ? glm::ivec2(1, 0) : glm::ivec2(0, 1); });
    entries.push_back(equation<float(glm::ivec2, glm::ivec2, glm::ivec2, int, float, float)>(
        {.id = "TSSAO-10",
         .function = "gloam_convergence_filter",
         .file = filter_file,
         .title = "smoothing that trusts neighbours as far as they have converged",
         .formula = "AO = (1/K) sum of g(|p - x|) conv(x) AO(x), K = sum of g(|p - x|) conv(x)",
         .source = "TSSAO (Mattausch et al.), eqs 10 and 11"},
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 along, glm::ivec2 size, int half_width,
           double c_adaptive, double sigma) {
            return reference::gloam_convergence_filter(pixel, along, size, half_width, c_adaptive, sigma,
                                                       values_of(images), positions_of(images));
        },
        {.domain = {image_pixel(), axis, image_size().only_as_drawn(),
                    integers(0, 6).and_near_integers({0, 2147483646L}),
                    uniform(0, 1).and_near({0.2}).and_special(), sigmas()},
         .budget = {.absolute = 8e-7},
         .codomain = {0, 1},
         .scenarios = surfaces()}));
}

}  // namespace

void append_filter(Entries& entries) {
    append_shrink(entries);
    append_gaussian(entries);
    append_sigma(entries);
    append_window(entries);
    append_mean(entries);
    append_filtering(entries);
    append_filter_keys(entries);
    append_edge_aware(entries);
    append_filter_resolution(entries);
}

}  // namespace gloam::catalogue
