// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/plan.hpp"

namespace gloam::effect {

// What the frame of three short passes (glsl/passes/frame) takes: prepare, sweep, and filter or join.
struct ShortSettings {
    std::string name;
    std::uint32_t slices = 1;
    std::uint32_t steps = 6;       // taps on each side of a slice
    bool half = false;             // the sweep takes every second pixel in both directions
    std::uint32_t half_width = 1;  // of the filter at full size: 1 is 3 x 3, 2 is 5 x 5
    OutputFormat output = OutputFormat::r8;
    bool history = false;  // frames follow one another
    float range = 0.0F;    // in a sequence: how far the mean may be from that of the last frames
    float sharpness =
        0.0F;  // and the part of the neighbours' weights that a long mean leaves out of a new frame

    friend bool operator==(const ShortSettings&, const ShortSettings&) = default;
};

// The frames that have names.
[[nodiscard]] const std::vector<ShortSettings>& short_frames();

// Throws std::invalid_argument that lists the names.
[[nodiscard]] const ShortSettings& short_frame_named(std::string_view name);

// The plan of such a frame, for a radius of 1.
[[nodiscard]] Plan plan_of(const ShortSettings& settings, const PlanOptions& options);

// The plan of a frame of this view, as its engine stores it. radius: of influence, world units.
[[nodiscard]] Plan plan_of(const ShortSettings& settings, const scene::GBuffer& view, float radius);

// Frames by these passes.
class ShortFrame {
  public:
    // The device must outlive this object.
    ShortFrame(const gpu::Device& device, const scene::PassLibrary& passes);

    // A frame of a view, as its engine stores it. radius: of influence, world units, > 0. Runs `repeat`
    // (>= 1) times and reports median times. `filtered` is what is shown; `occlusion` is the same. Missing
    // normals are made from depth by the sweep.
    // Throws std::invalid_argument for images of another size and for a radius out of range,
    // std::runtime_error like gpu::Commands::submit().
    // With a history a frame follows the last one, if its camera knows the one before, or is the same, and
    // size, radius and settings are the same; otherwise it begins a sequence.
    [[nodiscard]] Frame run(const scene::GBuffer& view, const ShortSettings& settings, float radius,
                            int repeat = 1);

    // The next frame begins a sequence.
    void cut();

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
