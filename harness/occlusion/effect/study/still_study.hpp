// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "effect/study/score.hpp"

namespace gloam::effect {

// A frame of a view that stands still.
struct StillFrame {
    double samples = 0.0;                  // taken by a pixel so far, mean over the pixels that need samples
    double weight = 0.0;                   // counted in the mean: the samples taken, up to the cap
    std::array<double, references> raw{};  // RMSE; NaN if the reference is unknown
    std::array<double, references> filtered{};
    double bias = 0.0;  // mean of image - limit
};

// Convergence of the effect on a view that stands still: `frames` frames, each compared with the references.
// Throws like AmbientOcclusion.
[[nodiscard]] std::vector<StillFrame> study_still(const gpu::Device& device, const scene::PassLibrary& passes,
                                                  const scene::GBuffer& view, const Settings& settings,
                                                  const References& truth, int frames,
                                                  const std::function<void(double)>& progress = {});

// Slope of the raw image's mean square error against the limit, as a function of the samples taken, on
// logarithmic axes (least squares). It uses the frames before the weight reaches its cap. -1 for independent
// samples. NaN for fewer than two such frames.
[[nodiscard]] double convergence_slope(const std::vector<StillFrame>& frames, double weight_max);

}  // namespace gloam::effect
