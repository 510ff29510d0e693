// SPDX-License-Identifier: MIT
#include "gpu/device.hpp"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "base/patience.hpp"
#include "gpu/internal/barrier.hpp"
#include "gpu/internal/context.hpp"
#include "gpu/internal/describe.hpp"
#include "gpu/internal/features.hpp"
#include "gpu/internal/guarded.hpp"
#include "gpu/internal/select.hpp"

namespace gloam::gpu {
namespace {

Physical choose(const vk::raii::Instance& instance, const std::string& selector) {
    auto devices = physical_devices(instance);
    std::vector<DeviceInfo> infos;
    for (const auto& device : devices) infos.push_back(describe(device, infos.size()));
    const auto chosen = select_device(infos, selector);
    return {std::move(devices[chosen]), std::move(infos[chosen])};
}

vk::raii::Device open_device(const Physical& physical, const vk::PhysicalDeviceFeatures& features) {
    constexpr float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = physical.queue_family, .queueCount = 1, .pQueuePriorities = &priority};
    return {physical.handle,
            {.queueCreateInfoCount = 1, .pQueueCreateInfos = &queue, .pEnabledFeatures = &features}};
}

const DeviceOptions& checked(const DeviceOptions& options) {
    if (options.timeout <= std::chrono::milliseconds::zero()) {
        throw std::invalid_argument(
            fmt::format("device timeout of {} ms: must be positive", options.timeout.count()));
    }
    return options;
}

}  // namespace

Physical::Physical(vk::raii::PhysicalDevice device, DeviceInfo description)
    : handle(std::move(device)),
      info(std::move(description)),
      properties(handle.getProperties()),
      memory(handle.getMemoryProperties()) {
    const auto family = find_queue_family(handle);
    if (!family) {
        throw std::runtime_error(
            fmt::format("Vulkan device \"{}\" has no queue for both graphics and compute", info.name));
    }
    queue_family = *family;
    const auto bits = handle.getQueueFamilyProperties()[queue_family].timestampValidBits;
    timestamp_mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

Device::Impl::Impl(const DeviceOptions& options)
    : log(checked(options).on_validation_message),
      loader(open_loader()),
      instance(create_instance(loader, options.validation == Validation::on ? &log : nullptr)),
      messenger(options.validation == Validation::on ? std::optional(create_messenger(instance, log))
                                                     : std::nullopt),
      physical(choose(instance, options.device)),
      device(open_device(physical, features_of(options, physical.handle.getFeatures()))),
      queue(device, physical.queue_family, 0),
      command_pool(device, vk::CommandPoolCreateInfo{.flags = vk::CommandPoolCreateFlagBits::eTransient,
                                                     .queueFamilyIndex = physical.queue_family}),
      fence(device, vk::FenceCreateInfo{}),
      sampler(device, vk::SamplerCreateInfo{}),
      cache(device, physical.properties, options.cache_directory, physical.info.identity),
      timeout(options.timeout) {}

Device::Impl::~Impl() {
    cache.save();
}

void Device::Impl::run_once(const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    Guarded<vk::raii::CommandBuffers> buffers(
        *this, vk::raii::CommandBuffers(device, {.commandPool = *command_pool,
                                                 .level = vk::CommandBufferLevel::ePrimary,
                                                 .commandBufferCount = 1}));
    const auto& commands = buffers->front();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    device_barrier(commands);
    record(commands);
    host_barrier(commands);
    commands.end();
    run(commands);
}

void Device::Impl::require_idle() {
    if (idle()) return;
    throw std::runtime_error(
        fmt::format("device \"{}\" still runs an earlier submission that timed out", physical.info.name));
}

void Device::Impl::run(const vk::raii::CommandBuffer& commands) {
    require_idle();
    try {
        device.resetFences(*fence);
        queue.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*commands}, *fence);
        busy_ = true;
        const auto result = wait();
        if (result == vk::Result::eTimeout) {
            throw std::runtime_error(fmt::format("device \"{}\" did not finish a submission within {} s",
                                                 physical.info.name,
                                                 std::chrono::duration<double>(timeout).count()));
        }
        busy_ = false;
    } catch (const vk::DeviceLostError&) {
        busy_ = false;  // work of a lost device counts as complete: destruction is allowed
        throw std::runtime_error(
            fmt::format("device \"{}\" was lost while it ran a submission: the shader crashed it, or its "
                        "driver's watchdog ended it",
                        physical.info.name));
    }
}

vk::Result Device::Impl::wait() const {
    // Whether the driver computes on the processor, in this process.
    constexpr std::chrono::milliseconds longest =
        std::chrono::years(100);  // in nanoseconds they fit a clock's count
    base::Patience patience(std::min(timeout, longest), [] { return base::processor_time_of(getpid()); });
    while (true) {
        const auto left =
            std::max(patience.next_look() - base::Patience::Clock::now(), std::chrono::nanoseconds(0));
        const vk::Result result =
            device.waitForFences(*fence, VK_TRUE, static_cast<std::uint64_t>(left.count()));
        if (result != vk::Result::eTimeout || patience.is_over()) return result;
    }
}

bool Device::Impl::idle() noexcept {
    if (!busy_) return true;
    try {
        busy_ = fence.getStatus() == vk::Result::eNotReady;
    } catch (...) {
        busy_ = false;  // lost
    }
    if (!busy_) kept_.clear();
    return !busy_;
}

Device::Device(const DeviceOptions& options) : impl_(std::make_unique<Impl>(options)) {}

Device::~Device() {
    if (!impl_->idle())
        static_cast<void>(impl_.release());  // leaked: it may not be destroyed, nor what it keeps
}

const DeviceInfo& Device::info() const {
    return impl_->physical.info;
}

std::vector<std::string> Device::take_validation_messages() {
    return impl_->log.take();
}

}  // namespace gloam::gpu
