// SPDX-License-Identifier: MIT
#include "catalogue/scenarios.hpp"

#include <fmt/format.h>

#include <limits>

namespace gloam::catalogue {
namespace {

constexpr glm::ivec2 sizes[] = {{1, 1}, {3, 5}, {17, 9}, {64, 2}, {1, 33}, {29, 43}};

// Two slanted surfaces, one in front of the other, with a few background pixels.
check::Image surface_depth(glm::ivec2 size, numeric::Random& random) {
    const float slope_x = static_cast<float>(random.uniform(-0.02, 0.02));
    const float slope_y = static_cast<float>(random.uniform(-0.02, 0.02));
    return check::make_image<float>(size, [&](glm::ivec2 pixel) {
        if (random.below(16) == 0) return std::numeric_limits<float>::infinity();
        const float base = (pixel.x + 2 * pixel.y) % 7 < 3 ? 2.0F : 3.0F;
        return base + slope_x * static_cast<float>(pixel.x) + slope_y * static_cast<float>(pixel.y);
    });
}

check::Image no_surface(glm::ivec2 size) {
    return check::make_image<float>(size, [](glm::ivec2) { return std::numeric_limits<float>::infinity(); });
}

}  // namespace

std::vector<check::ImageScenario> image_scenarios(
    const std::function<check::ImageSet(glm::ivec2 size, numeric::Random& random)>& make) {
    std::vector<check::ImageScenario> scenarios;
    for (const glm::ivec2 size : sizes) {
        scenarios.push_back({.name = fmt::format("{} x {}", size.x, size.y), .size = size, .make = make});
    }
    return scenarios;
}

std::vector<check::ImageScenario> depth_scenarios(const std::string& prototype) {
    auto scenarios = image_scenarios([prototype](glm::ivec2 size, numeric::Random& random) {
        return check::ImageSet{{prototype, surface_depth(size, random)}};
    });
    scenarios.push_back(
        {.name = "all background", .size = {5, 4}, .make = [prototype](glm::ivec2 size, numeric::Random&) {
             return check::ImageSet{{prototype, no_surface(size)}};
         }});
    return scenarios;
}

}  // namespace gloam::catalogue
