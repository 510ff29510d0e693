// SPDX-License-Identifier: MIT
#pragma once

#include "effect/study/benchmark_views.hpp"
#include "effect/study/configuration_study.hpp"
#include "effect/study/plain_slices.hpp"

namespace gloam::effect {

// Single frames of the plain loop, measured like the configurations of a ConfigurationStudy.
class PlainRun {
  public:
    // `blurs`: times that the plain blur is applied, >= 0. Throws like PlainSlices.
    PlainRun(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent, SliceTaps taps,
             int blurs);

    // Round 0 judges all scored frames. Each later round times them, each beside a copy. Throws like
    // PlainSlices::take(), which refuses orthographic cameras.
    [[nodiscard]] ConfigurationVisit visit(BenchmarkViews& views, CopyClock& clock, int round);

  private:
    PlainSlices slices_;
};

}  // namespace gloam::effect
