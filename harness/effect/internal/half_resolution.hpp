// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/view_images.hpp"
#include "effect/settings.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The setting `resolution` = half: all passes run over images of half the view's size. One pass before them
// takes every second pixel of every second row, and one after them brings the occlusion to the view's size.

// Push constants of halve_inputs.comp.
struct HalveParameters {
    glm::vec2 p00_p11;
    glm::vec2 previous_p00_p11;
    glm::ivec2 size;
};

// Push constants of upsample.comp.
struct UpsampleParameters {
    glm::ivec2 size;
    float a;
    float b;
    float c;
};

// Size of the half-size image: half of each side, rounded up.
[[nodiscard]] gpu::Extent half_of(gpu::Extent extent);

// The view whose images the passes read: `view`, or at half the resolution its half-size view. Its camera has
// another projection where a side is odd. Its band is at least one pixel smaller than half of the band,
// because pixels at the edge of the frame are interpolated from it.
[[nodiscard]] View working_view(const View& view, Resolution resolution);

// The camera of the half-size image is in the middle of it, half a pixel of the view away from where its
// pixels are. Its view space is sheared by that (perspective) or shifted (orthographic). This is the motion
// `previous_from_current` of the views between these spaces.
[[nodiscard]] glm::mat4 half_previous_from_current(const View& view, const View& previous);

[[nodiscard]] HalveParameters halve_parameters(const View& view, const View& previous);
[[nodiscard]] UpsampleParameters upsample_parameters(const View& view, const Settings& settings);

// What the pipeline of the pass over the inputs is compiled for.
struct HalveProgram {
    bool orthographic = false;
    bool previous_orthographic = false;
    bool moving_objects = false;
    bool layers = false;

    friend auto operator<=>(const HalveProgram&, const HalveProgram&) = default;
};

// What the pipeline of the pass over the result is compiled for.
struct UpsampleProgram {
    std::optional<HistoryPrecision> history;  // of the history that it reads; none: an image of one channel
    OutputFormat output = OutputFormat::r32f;
    bool maps = false;  // remaps what it writes
    bool orthographic = false;

    friend auto operator<=>(const UpsampleProgram&, const UpsampleProgram&) = default;
};
// filtered: the frame has a filter.
[[nodiscard]] UpsampleProgram upsample_program_for(const Settings& settings, bool filtered,
                                                   bool orthographic);

[[nodiscard]] PassSource halve_source(const HalveProgram& program);
[[nodiscard]] PassSource upsample_source(const UpsampleProgram& program);

// The full-size images around the half-size passes, and the two passes between them.
class HalfResolution {
  public:
    HalfResolution(const gpu::Device& device, const scene::PassLibrary& library, gpu::Extent extent);

    // Takes the view in `inputs` for the next frames. previous: the view before it, whose size is the same.
    // half: what the passes read; gets images for what the view has.
    void take(const View& view, const View& previous, const Settings& settings, ViewImages& half);

    // Appends the pass that writes the half-size inputs. The steps are valid until the next take().
    void append_inputs(const ViewImages& half, const gpu::Image& nothing, std::vector<Step>& steps);

    // Appends the pass that writes the result. half: as above. from: its occlusion, as the program has it.
    void append_result(const ViewImages& half, const gpu::Image& from, const UpsampleProgram& program,
                       std::vector<Step>& steps);

    ViewImages inputs;  // of the view's size

    // What is displayed, of the view's size.
    [[nodiscard]] const gpu::Image& result() const { return *result_; }

  private:
    const gpu::Device* device_;
    scene::PassLibrary library_;
    HalveProgram halving_;
    HalveParameters halve_constants_{};
    UpsampleParameters upsample_constants_{};
    std::optional<gpu::Image> result_;
    std::map<HalveProgram, gpu::ComputePipeline> halves_;
    std::map<UpsampleProgram, gpu::ComputePipeline> upsamples_;
};

// Each pixel's value of a half-size image at the pixels of an image of this size: that of its block of 2 x 2.
[[nodiscard]] std::vector<float> expanded(const std::vector<float>& half, gpu::Extent extent);

}  // namespace gloam::effect
