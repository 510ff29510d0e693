// SPDX-License-Identifier: MIT
#pragma once

#include "effect/ambient_occlusion.hpp"

namespace gloam::effect {

// Samples of a sequence that the limit leaves to those who are compared with it, and takes itself.
constexpr std::uint32_t limit_first = 1'024;
constexpr std::uint32_t limit_samples = 4'096;

// What an estimator converges to on one view: the mean of its samples 1025 to 5120, unrotated. It shares no
// sample with an effect that has taken up to 1024, so that the difference of the two holds the errors of
// both.
class Limit {
  public:
    // The device must outlive this. Throws like AmbientOcclusion.
    Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // Throws like AmbientOcclusion.
    [[nodiscard]] std::vector<float> of(const scene::GBuffer& view, const Settings& settings);

  private:
    AmbientOcclusion effect_;
};

}  // namespace gloam::effect
