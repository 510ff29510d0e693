// SPDX-License-Identifier: MIT
#include "effect/study/plain_slices.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"

namespace gloam::effect {
namespace {

using enum backend::vulkan::Format;

constexpr float depth_tolerance = 0.02F;

backend::vulkan::ComputePipeline slices_pipeline(const backend::vulkan::Device& device,
                                                 const scene::PassLibrary& passes, SliceTaps taps) {
    require_timestamps(device.info());
    return pipeline_of(device, passes,
                       {.file = "study/comparison/plain_slices.comp",
                        .constants = {{.id = 0, .bits = taps.slices}, {.id = 1, .bits = taps.steps}}});
}

backend::vulkan::ComputePipeline blur_pipeline(const backend::vulkan::Device& device,
                                               const scene::PassLibrary& passes) {
    return pipeline_of(device, passes, {.file = "study/comparison/plain_blur.comp"});
}

}  // namespace

void require_timestamps(const backend::DeviceInfo& device) {
    if (device.timestamp_period_ns > 0.0) return;
    throw std::runtime_error(fmt::format(
        "device \"{}\" has no timestamps: expected one that can tell how long a pass takes", device.name));
}

PlainSlices::PlainSlices(const backend::vulkan::Device& device, const scene::PassLibrary& passes,
                         backend::Extent extent, SliceTaps taps, int blurs)
    : device_(&device),
      slices_(slices_pipeline(device, passes, taps)),
      blur_(blur_pipeline(device, passes)),
      depth_(device, extent, r32f),
      normal_(device, extent, rgba32f),
      occlusion_(device, extent, r32f) {
    for (int i = 0; i < blurs; ++i) blurred_.emplace_back(device, extent, r32f);
}

void PlainSlices::take(const scene::GBuffer& view, float radius) {
    if (view.camera.orthographic())
        throw std::invalid_argument("plain slices: an orthographic camera, expected a perspective one");
    depth_.upload(view.depth);
    normal_.upload(texels_of(view.normal));
    const glm::ivec2 size(view.extent.width, view.extent.height);
    slice_parameters_ = {.p00_p11 = view.camera.p00_p11(), .size = size, .radius = radius};
    blur_parameters_ = {.size = size, .tolerance = depth_tolerance};
}

PlainFrame PlainSlices::next(int repeat) {
    const auto groups = groups_for(depth_.extent());
    std::vector<Step> steps{
        {"plain_slices", &slices_, {depth_, normal_, occlusion_}, bytes_of(slice_parameters_), groups}};
    const backend::vulkan::Image* last = &occlusion_;
    for (const backend::vulkan::Image& blurred : blurred_) {
        steps.push_back({"plain_blur", &blur_, {depth_, *last, blurred}, bytes_of(blur_parameters_), groups});
        last = &blurred;
    }
    const std::vector<PassTime> times = run(*device_, steps, repeat);
    PlainFrame frame{
        .occlusion = occlusion_.download(), .blurred = last->download(), .slices_ms = times.at(0).ms};
    for (std::size_t i = 1; i < times.size(); ++i) frame.blur_ms += times[i].ms;
    return frame;
}

}  // namespace gloam::effect
