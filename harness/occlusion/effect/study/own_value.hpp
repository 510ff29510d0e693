// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "effect/study/expectation.hpp"
#include "effect/study/seen_surface.hpp"

namespace gloam::effect {

// The value to which the mean of a method's samples converges, as an integral over the continuous
// distribution of its samples.
struct OwnValue {
    std::string name;
    // The contribution of one sample (or pair, or slice), from the published equations, in double. It shares
    // neither code nor sequences with the shaders. Settings are for a radius of 1.
    Integrand (*integrand)(const SeenSurface&, const Settings&) = nullptr;
    std::string none{};      // if there is no integrand: the reason
    bool of_pixels = false;  // the value grows without bound as pixels shrink
};

// The own values, one for each of methods().
[[nodiscard]] const std::vector<OwnValue>& own_values();

// The own value of the method with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const OwnValue& own_value_of(std::string_view method);

// The occlusion, before the remap, to which the settings' method converges at the view's point. pixels: of a
// side of the image; 0: the limit of ever more pixels. nullopt if the method has no integrand. Throws
// std::invalid_argument for settings of another radius than 1.
[[nodiscard]] std::optional<Estimate> own_value(const scene::ClosedFormView& view, const Settings& settings,
                                                std::uint32_t pixels, double tolerance);

}  // namespace gloam::effect
