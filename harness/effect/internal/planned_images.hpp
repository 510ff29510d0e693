// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// The images that the passes of a frame read or write, for a view of that size.
[[nodiscard]] std::vector<PlannedImage> planned_images(const Settings& settings, const PlanOptions& options,
                                                       gpu::Extent view);

}  // namespace gloam::effect
