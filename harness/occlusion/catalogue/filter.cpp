// SPDX-License-Identifier: MIT
// The convergence-aware filter, the filters of SAO and MSSAO.
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

Values lengths() {
    return either(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38))
        .and_near({0x1p-126, numeric::largest_float})
        .and_special();
}

void append_gaussian(Entries& entries) {
    const Values convergence = either(uniform(0, 1.1), log_uniform(1e-30, 1)).and_special();
    const Values threshold =
        either(uniform(0, 1), log_uniform(1e-37, 1e38)).and_near({0.2, 0x1p-126}).and_special();
    add(entries, "TSSAO-11", &reference::gloam_shrink,
        Domain{convergence, threshold}.tied(0, 1).tied(0, 1, 0.5), {.ulp = 3}, {0, 1});
    const Values squares = either(uniform(0, 1), lengths()).and_near({99.5}).and_special();
    add(entries, "TSSAO-10-g", &reference::gloam_gaussian, {squares, lengths()}, {.absolute = 3e-7}, {0, 1});
    add(entries, "TSSAO-10-g-scale", &reference::gloam_gaussian_scale, {lengths().and_near({0x1p100})},
        {.ulp = 2.5}, {0, numeric::infinity});
    add(entries, "TSSAO-10-g-scaled", &reference::gloam_gaussian_scaled, {squares, lengths()},
        {.absolute = 3e-7}, {0, 1});
    add(entries, "TSSAO-10-sigma", &reference::gloam_filter_sigma,
        {log_uniform(1e-3, 1e6).and_special(), uniform(0.1, 2).and_special(),
         log_uniform(1, 16384).and_special(), uniform(0.25, 8).and_special()},
        {.ulp = 4}, {0, numeric::largest_float}, [](double d, double tangent, double height, double pixels) {
            return moderate(1e-9, 1e9, d, tangent, height, pixels);
        });
}

void append_windows_and_means(Entries& entries) {
    add(entries, "TSSAO-11-window", &reference::gloam_window_coverage,
        {integers(1, 8).and_near_integers({16777216}), uniform(0, 8).and_near({1.0, 2.0}).and_special()}, {},
        {0, 1}, [](int offset, double reach) { return offset < 16 && !(reach > 16 && reach < 1e30); });
    const Values weight = either(uniform(0, 1), log_uniform(1e-12, 1)).and_special();
    // Sums of a few values: (sum, weight, low, high) with low <= sum / weight <= high.
    const Values mean = made_by<glm::vec4>([](numeric::Random& random) {
                            const double low = random.unit();
                            const double high = random.uniform(low, 1);
                            const double weight =
                                random.below(4) == 0 ? random.uniform(0, 3e-8) : random.uniform(0, 5);
                            return glm::vec4(random.uniform(low, high) * weight, weight, low, high);
                        }).only_as_drawn();
    add(entries, "TSSAO-10-empty", &reference::gloam_weighted_mean_empty, {}, {}, {0, 1});
    add(entries, "TSSAO-10-add", &reference::gloam_weighted_mean_add, {mean, shares(), weight}, {.ulp = 1.5},
        {0, numeric::largest_float});
    add(entries, "TSSAO-10-mean", &reference::gloam_weighted_mean_value,
        {mean.and_value(glm::vec4(0.5E-8F, 1e-8F, 0, 1), true), shares()}, {.ulp = 2.5, .backward_ulp = 1},
        {0, 1});
}

constexpr const char* values_name = "gloam_fetch_occlusion_convergence";
constexpr const char* positions_name = "gloam_fetch_position";

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

void append_filtering(Entries& entries) {
    add(entries, "TSSAO-10-weight", &reference::gloam_convergence_weight,
        {vector(3, uniform(-0.5, 0.5)).and_special(), uniform(0, 1),
         either(log_uniform(3, 300), log_uniform(1e-6, 1e6)).and_special(), uniform(0, 1)},
        {.absolute = 5e-7}, {0, 1}, [](glm::dvec3 v, double coverage, double scale, double convergence) {
            return moderate(1e-15, 1e15, v) && moderate(1e-30, 1.0, coverage) && scale >= 1e-6 &&
                   convergence >= 0 && convergence <= 1;
        });
    add(
        entries, "TSSAO-10",
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 along, glm::ivec2 size, int half_width,
           double c_adaptive, double sigma) {
            return reference::gloam_convergence_filter(pixel, along, size, half_width, c_adaptive, sigma,
                                                       fetch_of<glm::dvec2>(images, values_name),
                                                       fetch_of<glm::dvec3>(images, positions_name));
        },
        {image_pixel(), image_axes(), image_size().only_as_drawn(),
         integers(0, 6).and_near_integers({0, 2147483646L}), uniform(0, 1).and_near({0.2}).and_special(),
         either(log_uniform(0.003, 0.3), log_uniform(1e-6, 1e6)).and_special()},
        {.absolute = 8e-7}, {0, 1}, nullptr, surfaces());
}

constexpr const char* occlusion_name = "gloam_fetch_occlusion";

// Noise of a small range, with a few invalid values.
ImageSet occlusion_image(glm::ivec2 size, numeric::Random& random) {
    const auto value = [&](glm::ivec2) {
        if (random.below(64) == 0) return random.below(2) == 0 ? NAN : 1.5F;
        return static_cast<float>(random.uniform(0.2, 0.4));
    };
    return {{occlusion_name, make_image<float>(size, value)}};
}

}  // namespace

void append_filter(Entries& entries) {
    append_gaussian(entries);
    append_windows_and_means(entries);
    append_filtering(entries);
    add(
        entries, "CS-E-dual",
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 size, double tolerance) {
            return reference::gloam_dual_resolution_disagrees(pixel, size, tolerance,
                                                              fetch_of<double>(images, occlusion_name));
        },
        {image_pixel(), image_size().only_as_drawn(), uniform(0, 0.3).and_special()}, {.backward_ulp = 1}, {},
        nullptr, image_scenarios(occlusion_image));
    add(entries, "CS-Q-blur", &reference::gloam_sao_blur_weight,
        {integers(-6, 6).and_near_integers({-2147483647, 2147483646}),
         either(signed_log_uniform(1e-6, 1), any_float()).and_special(),
         either(log_uniform(10, 10000), any_float()).and_special()},
        {.absolute = 2e-7}, {0, 0.445});
    const Values depth = either(uniform(1, 3), log_uniform(1e-37, 1e38)).and_special();
    const Values near_ones = made_by<glm::vec4>([](numeric::Random& random) {
        glm::vec4 depths(0);
        for (int i = 0; i < 4; ++i) depths[i] = 2.0F + 0.125F * static_cast<float>(random.below(5));
        return depths;
    });
    add(entries, "CS-F-rank", &reference::gloam_depth_rank,
        {either(vector(4, depth), near_ones), integers(-1, 4)});
    add(entries, "CS-F-weights", &reference::gloam_mssao_weights,
        {either(vector(4, depth), near_ones), either(uniform(0, 1), constant(0.25F)).and_special()},
        {.backward_ulp = 1}, {0, 1});
    add(entries, "CS-F-normal", &reference::gloam_mssao_normal, {normals(), normals()}, {.absolute = 4e-7},
        {-1.000001, 1.000001},
        [](glm::dvec3 a, glm::dvec3 b) { return moderate(0.0, 1e18, a, b) && glm::length(a + b) >= 0.25; });
    const Values power = either(uniform(0.25, 10), constant(1.0F)).and_near({0.0}).and_special();
    add(entries, "CS-F-upsample", &reference::gloam_mssao_upsample_weight,
        {uniform(0, 1).and_special(), either(signed_log_uniform(1e-3, 10), any_float()).and_special(),
         uniform(-1, 1).and_near({-1.0, 1.0}).and_special(), power, power},
        {.absolute = 3e-6}, {0, 1}, [](double, double dz, double cosine, double a, double b) {
            return moderate(0.0, 1e18, dz) && moderate(0.0, 1e9, cosine) && moderate(0.25, 16, a, b) &&
                   a < 1e9 && b < 1e9;
        });
}

}  // namespace gloam::catalogue
