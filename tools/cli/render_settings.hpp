// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "cli/render.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {

// Settings for a view: the preset and the method, scaled to the radius that the options or else the view
// give, then the other options, last --set in its order. Throws std::invalid_argument for names and values
// that cannot be, and where there is no radius.
[[nodiscard]] effect::Settings settings_for(const RenderOptions& options,
                                            const std::optional<double>& view_radius);

}  // namespace gloam::cli
