// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "gpu/commands.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Throws std::runtime_error that names the device where it has no timestamps: nothing can be timed on it.
void require_timestamps(const gpu::DeviceInfo& device);

// How long a copy takes: a pass that reads one texel and writes one, for each pixel of images of one size.
// Times stated in copies of r32f can be compared across machines, and cancel a machine's drift.
class CopyClock {
  public:
    // The device must outlive this. Throws std::invalid_argument for depth32f, std::runtime_error without
    // timestamps, and like gpu::Image.
    CopyClock(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
              gpu::Format format = gpu::Format::r32f);

    // Copies a few times; returns the median of the last readings, in milliseconds: a single one of so short
    // a pass says little.
    double measure();

    // Copies a few times; returns the median of these alone, in milliseconds: for what is timed beside them.
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
