// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "effect/study/plain_slices.hpp"

namespace gloam::effect {

// The sampling pass of a method and the plain loop with equal taps, timed in turn.
struct PlainComparison {
    std::string method;
    SliceTaps taps;
    std::vector<double> plain_ms;   // one reading a round
    std::vector<double> method_ms;  // of the sampling pass alone
    double difference = 0.0;        // RMS of the two images: both estimate the same where both are right
};

// A single frame of a method of slices with so many taps, without history and filter. Radius 1. Throws
// std::invalid_argument for a method whose samples are not slices.
[[nodiscard]] Settings single_frame_of_slices(const std::string& method, SliceTaps taps);

// Compares each method with the plain loop, for each number of taps, on one view. All take turns in each of
// the rounds. Throws std::invalid_argument for rounds < 1, and like single_frame_of_slices(), PlainSlices and
// AmbientOcclusion.
[[nodiscard]] std::vector<PlainComparison> compare_with_plain(const gpu::Device& device,
                                                              const scene::PassLibrary& passes,
                                                              const scene::GBuffer& view, float radius,
                                                              std::span<const std::string> methods,
                                                              std::span<const SliceTaps> taps, int rounds);

}  // namespace gloam::effect
