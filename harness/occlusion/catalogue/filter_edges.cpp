// SPDX-License-Identifier: MIT
// Filters that stop at edges, and which pixels an image of half the resolution stands for.
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

constexpr const char* occlusion_name = "gloam_fetch_occlusion";
constexpr const char* normal_name = "gloam_fetch_normal";

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
    images.emplace(depth_prototype, make_image<float>(size, depth));
    return images;
}

void append_bilateral(Entries& entries) {
    const Values pixels = either(uniform(0.5, 4), log_uniform(1e-30, 1e30)).and_special();
    const Values lengths = either(log_uniform(0.01, 2), log_uniform(1e-30, 1e30)).and_special();
    add(entries, "ISSAO-7-weight", &reference::gloam_bilateral_weight,
        {vector(2, uniform(-8, 8)).and_value(glm::vec2(0)),
         either(uniform(-1, 1), signed_log_uniform(1e-37, 1e38)).and_special(), pixels, lengths},
        {.absolute = 4e-7}, {0, 1}, [](glm::dvec2 offset, double difference, double, double) {
            return moderate(1e-15, 1e15, offset, difference);
        });
    const Values sigma_d = uniform(0.5, 4).and_special();
    const Values sigma_r = log_uniform(0.01, 2).and_special();
    // Few taps, because the number of paths of an interval grows with every tap.
    const Values half_width = either(vector(2, integers(0, 1)), vector({integers(0, 3), integers(0, 0)}))
                                  .and_value(glm::ivec2(0, -5));
    add(
        entries, "ISSAO-7",
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 half, glm::ivec2 size, double sigma_d,
           double sigma_r) {
            return reference::gloam_bilateral_filter(pixel, half, size, sigma_d, sigma_r,
                                                     fetch_of<double>(images, occlusion_name),
                                                     fetch_of<double>(images, depth_prototype));
        },
        {image_pixel(), half_width, image_size(), sigma_d, sigma_r}, {.absolute = 6e-7}, {0, 1}, nullptr,
        image_scenarios(noisy_surface));
}

}  // namespace

void append_filter_edges(Entries& entries) {
    append_bilateral(entries);
    add(entries, "CS-BLUR-weight", &reference::gloam_geometry_weight,
        {unit_vector(3).and_value(glm::vec3(0)).and_special(), unit_vector(3).and_value(glm::vec3(0)),
         either(uniform(-4, 4), signed_log_uniform(1e-30, 1e30)).and_special(),
         uniform(1, 16).and_near({10.0}).and_special(), uniform(0, 2).and_near({0.0, 0.5}).and_special()},
        {.absolute = 3e-6}, {0, 1}, [](glm::dvec3 n, glm::dvec3, double, double by_normal, double by_depth) {
            return moderate(1e-9, 1.1, n) && by_normal >= 1 && by_normal <= 17 && by_depth <= 3;
        });
    const Values powers = vector({uniform(1, 16), uniform(0, 1)});
    add(
        entries, "CS-BLUR",
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 along, glm::ivec2 size, int half_width,
           glm::dvec2 exponents) {
            return reference::gloam_geometry_blur(
                pixel, along, size, half_width, exponents, fetch_of<double>(images, occlusion_name),
                fetch_of<double>(images, depth_prototype), fetch_of<glm::dvec3>(images, normal_name));
        },
        {image_pixel(), image_axes(), image_size().only_as_drawn(), integers(0, 4).and_near_integers({0}),
         powers},
        {.absolute = 1e-6}, {0, 1}, nullptr, image_scenarios(noisy_surface));
    const Values size = integers(0, 1 << 30);
    add(entries, "HALF-size", &reference::gloam_half_size,
        {either(vector(2, integers(0, 9)), vector(2, size))});
    add(entries, "HALF-source", &reference::gloam_half_source, {vector(2, integers(-(1 << 29), 1 << 29))});
}

}  // namespace gloam::catalogue
