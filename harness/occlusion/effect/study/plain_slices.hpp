// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Throws std::runtime_error with the device's name if it has no timestamps, so that nothing can be timed on
// it.
void require_timestamps(const backend::DeviceInfo& device);

// Taps of one pixel: so many on each side of each slice.
struct SliceTaps {
    std::uint32_t slices = 9;
    std::uint32_t steps = 3;
};

// A single frame of the plain loop, and how long its passes took.
struct PlainFrame {
    std::vector<float> occlusion;  // raw
    std::vector<float> blurred;    // mean over 3 x 3 pixels that are about as deep, so many times
    double slices_ms = 0.0;
    double blur_ms = 0.0;
};

// Ground-truth ambient occlusion as one plain loop over slices, and a plain blur: what an engine without this
// library has. Methods are compared with it (glsl/passes/study/comparison).
class PlainSlices {
  public:
    // `blurs`: times that the blur is applied. The device must outlive this object. Throws std::runtime_error
    // without timestamps, and like backend::vulkan::Image.
    PlainSlices(const backend::vulkan::Device& device, const scene::PassLibrary& passes,
                backend::Extent extent, SliceTaps taps, int blurs = 1);

    // The next frames are of this view, which has the images' size, normals, and no guard band. radius: of
    // influence, world units, > 0. Throws std::invalid_argument for an orthographic camera.
    void take(const scene::GBuffer& view, float radius);

    // Runs the passes `repeat` times (>= 1) and gives their median times.
    [[nodiscard]] PlainFrame next(int repeat = 1);

  private:
    struct SliceParameters {
        glm::vec2 p00_p11{1};
        glm::ivec2 size{0};
        float radius = 1.0F;
    };
    struct BlurParameters {
        glm::ivec2 size{0};
        float tolerance = 0.0F;
    };

    const backend::vulkan::Device* device_;
    backend::vulkan::ComputePipeline slices_;
    backend::vulkan::ComputePipeline blur_;
    backend::vulkan::Image depth_;
    backend::vulkan::Image normal_;
    backend::vulkan::Image occlusion_;
    std::vector<backend::vulkan::Image> blurred_;  // one for each blur
    SliceParameters slice_parameters_;
    BlurParameters blur_parameters_;
};

}  // namespace gloam::effect
