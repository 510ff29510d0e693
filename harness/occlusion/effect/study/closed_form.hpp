// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "effect/ambient_occlusion.hpp"
#include "scene/analytic_scene.hpp"

namespace gloam::effect {

// A measured number and its standard error.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

// Measures methods on closed-form views with the real passes: with history, without filter, remap and
// rotation.
class ClosedFormStudy {
  public:
    // pixels: on each side of the image, odd. The device must outlive this object. Throws like
    // AmbientOcclusion.
    ClosedFormStudy(const gpu::Device& device, const scene::PassLibrary& passes, std::uint32_t pixels);

    // The occlusion of the view's point: the mean over all frames of 1024 samples, with a standard error from
    // the spread of the frames' means. Consecutive frames of a low-discrepancy sequence have opposite errors,
    // so the actual error of the mean is smaller than this estimate. Settings are for a radius of 1. Throws
    // like AmbientOcclusion, and std::invalid_argument for fewer than two frames.
    [[nodiscard]] Estimate measure(const scene::ClosedFormView& view, const Settings& settings, int frames);

  private:
    AmbientOcclusion effect_;
    std::uint32_t pixels_;
};

}  // namespace gloam::effect
