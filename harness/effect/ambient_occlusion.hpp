// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// GPU time of one pass; NaN where the device has no timestamps.
struct PassTime {
    std::string pass;
    double milliseconds = 0.0;
};

// How many were computed, and how many were not, and why.
struct Tally {
    std::uint64_t total = 0;
    std::uint64_t shaded = 0;
    std::uint64_t background = 0;
    std::uint64_t without_normal = 0;
    std::uint64_t radius_below_a_pixel = 0;
    std::uint64_t skipped_for_several_reasons = 0;  // tiles only
};

struct Work {
    std::uint64_t samples = 0;  // taken, those dropped not counted
    Tally pixels;
    Tally tiles;  // work groups; shaded: at least one pixel was
};

// Occlusion of one frame, rows from the top: in [0, 1], 0 at the background.
struct Frame {
    std::vector<float> raw;       // as accumulated
    std::vector<float> occlusion; // filtered; the same as raw without a filter
    std::vector<PassTime> times;  // in the order of execution; median over the repeats
    Work work;
};

enum class History { keep, restart };

// Ambient occlusion of images of one size. Frame after frame it accumulates samples for each pixel, with the
// history at the same pixel: right as long as nothing moves. When something does, restart.
class AmbientOcclusion {
  public:
    // radius: of influence, world units. Throws std::runtime_error for a size that the device does not allow,
    // std::invalid_argument for settings outside their range.
    AmbientOcclusion(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent, const Method& method,
                     const Settings& settings, double radius);
    ~AmbientOcclusion();
    AmbientOcclusion(AmbientOcclusion&&) noexcept;
    AmbientOcclusion& operator=(AmbientOcclusion&&) noexcept;

    // The next frame, computed 1 + `repeats` times from the same history: once to count the work, then to be timed
    // (no times for 0). Throws std::invalid_argument for a G-buffer of another size.
    [[nodiscard]] Frame run(const scene::GBuffer& gbuffer, History history, int repeats = 1);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::effect
