// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/study/skip_study.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Views of which a share can be skipped for one reason. They show a rough floor, which gives no other reason
// to skip. The given share of the image is background, is smooth, or has settled.
struct SkipShare {
    double share = 0.0;  // of the image, 0 to 1
    SkipCase skip_case;
};

// Cases for each reason, with shares up to 0.95 or 1. Throws like scene::rasterize().
[[nodiscard]] std::vector<SkipShare> skip_shares(const gpu::Device& device, const scene::PassLibrary& passes,
                                                 gpu::Extent extent);

}  // namespace gloam::effect
