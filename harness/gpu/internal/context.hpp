// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/internal/instance.hpp"
#include "gpu/internal/pipeline_cache.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// The physical device of a selector, and its frequently used properties.
struct Physical {
    Physical(vk::raii::PhysicalDevice device, DeviceInfo description);

    vk::raii::PhysicalDevice handle;
    DeviceInfo info;
    vk::PhysicalDeviceProperties properties;
    vk::PhysicalDeviceMemoryProperties memory;
    std::uint32_t queue_family = 0;
    std::uint64_t timestamp_mask = 0;  // the valid bits of a reading; 0: no timestamps
};

// The open device, which every other object of this room uses.
struct Device::Impl {
    explicit Impl(const DeviceOptions& options);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    // Records commands, runs them and waits.
    void run_once(const std::function<void(const vk::raii::CommandBuffer&)>& record);

    // Submits and waits. Throws std::runtime_error on a lost device, after the timeout, and while an earlier
    // submission that timed out still runs.
    void run(const vk::raii::CommandBuffer& commands);

    // False while a submission that timed out still runs; nothing may be destroyed then.
    [[nodiscard]] bool idle() noexcept;
    // Throws std::runtime_error while a submission that timed out still runs.
    void require_idle();

    // Keeps objects that must not be destroyed until the device is idle.
    void keep(std::shared_ptr<void> handles) { kept_.push_back(std::move(handles)); }

    // The order of declaration matters: destruction runs from last to first.
    MessageLog log;
    vk::raii::Context loader;
    vk::raii::Instance instance;
    std::optional<vk::raii::DebugUtilsMessengerEXT> messenger;
    Physical physical;
    vk::raii::Device device;
    vk::raii::Queue queue;
    vk::raii::CommandPool command_pool;
    vk::raii::Fence fence;
    vk::raii::Sampler sampler;  // of all sampled images: no fetch uses it
    PipelineCache cache;
    std::chrono::milliseconds timeout;

  private:
    [[nodiscard]] vk::Result wait() const;
    bool busy_ = false;
    std::vector<std::shared_ptr<void>> kept_;
};

using Context = Device::Impl;

}  // namespace gloam::gpu
