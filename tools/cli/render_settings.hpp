// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "cli/render.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {

// Settings for a view: the preset and the method, scaled to the radius of the options or of the view, then
// the other options, then every --set in order. Throws std::invalid_argument for invalid names and values,
// and if there is no radius.
[[nodiscard]] effect::Settings settings_for(const RenderOptions& options,
                                            const std::optional<double>& view_radius);

}  // namespace gloam::cli
