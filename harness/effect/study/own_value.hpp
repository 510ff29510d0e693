// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "effect/study/expectation.hpp"
#include "effect/study/seen_surface.hpp"

namespace gloam::effect {

// What the mean of a method's samples tends to, as an integral over the continuous distribution of its
// samples.
struct OwnValue {
    std::string name;
    // What one sample (or pair, or slice) contributes, from the published equations and in double: no code of
    // the shaders and none of their sequences. Settings are for a radius of 1.
    Integrand (*integrand)(const SeenSurface&, const Settings&) = nullptr;
    std::string none{};      // without an integrand: why there is none
    bool of_pixels = false;  // what it tends to grows without bound as pixels shrink
};

// One for each of methods().
[[nodiscard]] const std::vector<OwnValue>& own_values();

// By name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const OwnValue& own_value_of(std::string_view method);

// The occlusion of the view's point that the settings' method tends to before the remap, on an image of so
// many pixels (0: of ever more pixels). nullopt where the method has no integrand. Throws
// std::invalid_argument for settings of another radius than 1.
[[nodiscard]] std::optional<Estimate> own_value(const scene::ClosedFormView& view, const Settings& settings,
                                                std::uint32_t pixels, double tolerance);

}  // namespace gloam::effect
