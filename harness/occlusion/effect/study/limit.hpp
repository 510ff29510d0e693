// SPDX-License-Identifier: MIT
#pragma once

#include "effect/ambient_occlusion.hpp"

namespace gloam::effect {

// The limit skips the first `limit_first` samples of a sequence and takes the next `limit_samples`.
constexpr std::uint32_t limit_first = 1'024;
constexpr std::uint32_t limit_samples = 4'096;

// The value to which an estimator converges on one view: the mean of its samples 1025 to 5120, without
// rotation. It shares no sample with an effect that has taken at most 1024. The difference between both
// therefore contains the errors of both.
class Limit {
  public:
    // The device must outlive this object. Throws like AmbientOcclusion.
    Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // The limit for each pixel of a view. Throws like AmbientOcclusion.
    [[nodiscard]] std::vector<float> of(const scene::GBuffer& view, const Settings& settings);

  private:
    AmbientOcclusion effect_;
};

}  // namespace gloam::effect
