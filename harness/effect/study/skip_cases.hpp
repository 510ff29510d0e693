// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/study/skip_study.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Cases: a mostly empty sky, a wide floor, a view that stands still and has settled, and a view with nothing
// to skip. Each has its target time. Throws like scene::rasterize().
[[nodiscard]] std::vector<SkipCase> skip_cases(const gpu::Device& device, const scene::PassLibrary& passes,
                                               gpu::Extent extent);

}  // namespace gloam::effect
