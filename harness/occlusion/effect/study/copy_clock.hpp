// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Throws std::runtime_error with the device's name if it has no timestamps, so that nothing can be timed on
// it.
void require_timestamps(const gpu::DeviceInfo& device);

// The copy that is timed: of storage images, binding 0 to binding 1, whose size are the push constants
// (ivec2). Throws like CopyClock.
[[nodiscard]] gpu::ComputePipeline copy_pipeline(const gpu::Device& device, const scene::PassLibrary& passes,
                                                 gpu::Format format);

// The time of a copy: a pass that reads one texel and writes one, for each pixel of images of one size. Times
// in copies of r32f can be compared across machines, and the drift of a machine cancels out.
class CopyClock {
  public:
    // The device must outlive this object. Throws std::invalid_argument for depth32f, std::runtime_error
    // without timestamps, and like gpu::Image.
    CopyClock(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
              gpu::Format format = gpu::Format::r32f);

    // Copies a few times. Returns the median of the last readings, in milliseconds; a single reading of so
    // short a pass is too noisy.
    double measure();

    // Copies a few times. Returns the median of these readings alone, in milliseconds, for a pass timed
    // beside them.
    double measure_now();

  private:
    [[nodiscard]] std::vector<double> times();

    const gpu::Device* device_;
    gpu::ComputePipeline pipeline_;
    gpu::Image from_;
    gpu::Image to_;
    std::deque<double> readings_;
};

}  // namespace gloam::effect
