// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "backend/vulkan/internal/instance.hpp"
#include "backend/vulkan/internal/vulkan.hpp"
#include "base/hidden.hpp"

namespace gloam::backend::vulkan {

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

    // Submits and waits. Throws backend::DeviceLost; backend::Hang after the timeout, and while an earlier
    // submission that timed out still runs.
    void run(const vk::raii::CommandBuffer& commands);

    // False while a submission that timed out still runs, and at the end of a process that has validation
    // layers; nothing may be destroyed then.
    [[nodiscard]] bool idle() noexcept;
    // Throws backend::Hang while a submission that timed out still runs.
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
    vk::raii::Sampler sampler;  // of all sampled images but SampledImage and LinearImage
    vk::raii::Sampler linear;
    // The driver's compiled pipelines are kept in a file for each device identity. A damaged file, or one of
    // another driver, is never passed to the driver: it counts as empty and is replaced.
    std::filesystem::path cache_file;  // empty: no cache
    std::string cached;                // what it held
    vk::raii::PipelineCache cache;
    std::chrono::milliseconds timeout;

  private:
    [[nodiscard]] vk::Result wait() const;
    bool busy_ = false;
    std::vector<std::shared_ptr<void>> kept_;
};

using Context = Device::Impl;

// The result of the work, with Vulkan's errors as errors of backends.
template <class Work>
auto with_typed_errors(const Work& work) {
    try {
        return work();
    } catch (const vk::DeviceLostError& error) {
        throw backend::DeviceLost(error.what());
    } catch (const vk::OutOfHostMemoryError& error) {
        throw backend::OutOfMemory(error.what());
    } catch (const vk::OutOfDeviceMemoryError& error) {
        throw backend::OutOfMemory(error.what());
    }
}

// Handles, with their device in `context`, that are destroyed with their owner; while a submission that timed
// out still runs, the device keeps them.
template <class Handles>
[[nodiscard]] base::Hidden<Handles> owned(Handles handles) {
    return {new Handles(std::move(handles)), [](Handles* object) {
                std::unique_ptr<Handles> own(object);
                Context& context = own->context;
                if (!context.idle()) context.keep(std::move(own));
            }};
}

// Memory with the first properties in `wishes` for which the device has a suitable type. Throws
// std::runtime_error with the purpose if there is no such type, backend::OutOfMemory.
[[nodiscard]] vk::raii::DeviceMemory allocate(const Context& context, const vk::MemoryRequirements& needs,
                                              std::initializer_list<vk::MemoryPropertyFlags> wishes,
                                              const std::string& purpose);

// Whether a module calculates in float16, and the device cannot.
[[nodiscard]] bool lacks_float16(const Context& context, std::span<const std::uint32_t> spirv);

// Drivers can crash on words that are not a module, so it throws std::invalid_argument unless these at least
// begin like one.
[[nodiscard]] vk::raii::ShaderModule make_module(const Context& context,
                                                 std::span<const std::uint32_t> spirv);

// bytes: of push constants. Throws std::invalid_argument unless they are a multiple of 4 within the device's
// limit.
[[nodiscard]] vk::raii::PipelineLayout make_layout(const Context& context,
                                                   const vk::raii::DescriptorSetLayout& set_layout,
                                                   vk::ShaderStageFlags stages, std::uint32_t bytes);

// On the device, all later commands see the writes of all earlier ones.
inline void device_barrier(const vk::raii::CommandBuffer& commands) {
    using Access = vk::AccessFlagBits;
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    commands.pipelineBarrier(all, all, {},
                             vk::MemoryBarrier{.srcAccessMask = Access::eMemoryWrite,
                                               .dstAccessMask = Access::eMemoryRead | Access::eMemoryWrite},
                             nullptr, nullptr);
}

// The host, after waiting, sees the writes of all earlier commands.
inline void host_barrier(const vk::raii::CommandBuffer& commands) {
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands, vk::PipelineStageFlagBits::eHost, {},
                             vk::MemoryBarrier{.srcAccessMask = vk::AccessFlagBits::eMemoryWrite,
                                               .dstAccessMask = vk::AccessFlagBits::eHostRead},
                             nullptr, nullptr);
}

// A command buffer that is begun, for one submission. Its commands see the writes of all earlier ones.
[[nodiscard]] vk::raii::CommandBuffers begun(const Context& context);

}  // namespace gloam::backend::vulkan
