// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "effect/study/score.hpp"

namespace gloam::effect {

// A frame of a view that stands still.
struct StillFrame {
    double samples = 0.0;  // that a pixel has taken so far, the mean over those that need samples
    double weight = 0.0;   // that count: as many, but never more than the cap
    std::array<double, references> raw{};  // RMSE; NaN where the reference is not known
    std::array<double, references> filtered{};
    double bias = 0.0;  // mean of image - limit
};

// How the effect converges on a view that stands still: `frames` frames, each compared with the references.
// Throws like AmbientOcclusion.
[[nodiscard]] std::vector<StillFrame> study_still(const gpu::Device& device, const scene::PassLibrary& passes,
                                                  const scene::GBuffer& view, const Settings& settings,
                                                  const References& truth, int frames,
                                                  const std::function<void(double)>& progress = {});

// Slope of the mean square error of the raw image against the limit, over the samples taken, on logarithmic
// axes (least squares), over the frames before the cap of the weight is reached. -1 for independent samples.
// NaN for fewer than two such frames.
[[nodiscard]] double convergence_slope(const std::vector<StillFrame>& frames, double weight_max);

}  // namespace gloam::effect
