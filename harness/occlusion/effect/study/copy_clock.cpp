// SPDX-License-Identifier: MIT
#include "effect/study/copy_clock.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/work.hpp"

namespace gloam::effect {
namespace {

constexpr int copies_at_once = 5;
constexpr std::size_t remembered = 75;

std::vector<std::string> defines_for(gpu::Format format) {
    switch (format) {
        case gpu::Format::r32f:
            return {};
        case gpu::Format::rgba32f:
            return {"GLOAM_FORMAT rgba32f"};
        case gpu::Format::rgba16f:
            return {"GLOAM_FORMAT rgba16f"};
        case gpu::Format::rgba16ui:
            return {"GLOAM_FORMAT rgba16ui", "GLOAM_INTEGERS"};
        default:
            throw std::invalid_argument("a copy of depth32f: expected a format of storage images");
    }
}

}  // namespace

void require_timestamps(const gpu::DeviceInfo& device) {
    if (device.timestamp_period_ns > 0.0) return;
    throw std::runtime_error(fmt::format(
        "device \"{}\" has no timestamps: expected one that can tell how long a pass takes", device.name));
}

gpu::ComputePipeline copy_pipeline(const gpu::Device& device, const scene::PassLibrary& passes,
                                   gpu::Format format) {
    require_timestamps(device.info());
    const shader::Spirv spirv = passes.compile("copy.comp", defines_for(format));
    return {device,
            {.spirv = spirv,
             .bindings = {gpu::BindingKind::storage_image, gpu::BindingKind::storage_image},
             .push_constant_bytes = sizeof(glm::ivec2)}};
}

CopyClock::CopyClock(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                     gpu::Format format)
    : device_(&device),
      pipeline_(copy_pipeline(device, passes, format)),
      from_(device, extent, format),
      to_(device, extent, format) {
    const auto channels = static_cast<std::size_t>(gpu::channels(format));
    from_.upload(std::vector<float>(channels * extent.width * extent.height, 0.0F));
    measure();  // drivers compile at the first dispatch
    readings_.clear();
    measure();
}

std::vector<double> CopyClock::times() {
    const gpu::Extent extent = from_.extent();
    const glm::ivec2 size(extent.width, extent.height);
    const std::vector<gpu::Resource> resources{std::cref(from_), std::cref(to_)};
    gpu::Commands commands(*device_);
    commands.timestamp();
    for (int i = 0; i < copies_at_once; ++i) {
        commands.dispatch(pipeline_, resources, groups_for(extent), std::as_bytes(std::span(&size, 1)));
        commands.timestamp();
    }
    commands.submit();
    const std::vector<double> stamps = commands.times_ms();
    std::vector<double> times;
    for (std::size_t i = 1; i < stamps.size(); ++i) times.push_back(stamps[i] - stamps[i - 1]);
    return times;
}

double CopyClock::measure_now() {
    return median(times());
}

double CopyClock::measure() {
    for (const double time : times()) readings_.push_back(time);
    while (readings_.size() > remembered) readings_.pop_front();
    const std::vector<double> recent(readings_.begin(), readings_.end());
    return median(recent);
}

}  // namespace gloam::effect
