// SPDX-License-Identifier: MIT
#pragma once

#include <gloam_effect.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vulkan/vulkan_raii.hpp>

struct Extent {
    std::uint32_t width, height;
};

// The first device that computes, with one queue and what is submitted to it at once.
class Device {
  public:
    Device()
        : physical_(pick()),
          family_(computing_family()),
          device_(make_device()),
          queue_(device_, family_, 0),
          pool_(device_, {vk::CommandPoolCreateFlagBits::eTransient, family_}) {}

    const vk::raii::Sampler& sampler() const { return sampler_; }  // the nearest texel
    const vk::raii::Device& get() const { return device_; }

    vk::raii::DeviceMemory memory(const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted) const {
        const vk::PhysicalDeviceMemoryProperties all = physical_.getMemoryProperties();
        for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
            if ((needs.memoryTypeBits >> i & 1U) != 0 &&
                (all.memoryTypes[i].propertyFlags & wanted) == wanted)
                return vk::raii::DeviceMemory(device_, vk::MemoryAllocateInfo(needs.size, i));
        throw std::runtime_error("the device has no such memory");
    }

    // Records, submits and waits.
    template <class Record>
    void run(const Record& record) const {
        const vk::raii::CommandBuffers buffers(device_, {*pool_, vk::CommandBufferLevel::ePrimary, 1});
        const vk::raii::CommandBuffer& commands = buffers.front();
        commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record(commands);
        commands.end();
        const vk::CommandBuffer submitted = *commands;
        queue_.submit(vk::SubmitInfo({}, {}, submitted));
        queue_.waitIdle();
    }

  private:
    vk::raii::PhysicalDevice pick() {
        vk::raii::PhysicalDevices all(instance_);
        if (all.empty()) throw std::runtime_error("no Vulkan device");
        return all.front();
    }
    std::uint32_t computing_family() const {
        const auto families = physical_.getQueueFamilyProperties();
        const auto computes = [](const auto& f) { return bool(f.queueFlags & vk::QueueFlagBits::eCompute); };
        return static_cast<std::uint32_t>(std::ranges::find_if(families, computes) - families.begin());
    }
    vk::raii::Device make_device() const {
        const float priority = 1.0F;
        const vk::DeviceQueueCreateInfo queue({}, family_, 1, &priority);
        return {physical_, vk::DeviceCreateInfo({}, queue)};
    }
    static vk::raii::Instance make_instance(const vk::raii::Context& context) {
        const vk::ApplicationInfo application("packed_effect", 1, "", 0, VK_API_VERSION_1_2);
        return {context, vk::InstanceCreateInfo({}, &application)};
    }

    vk::raii::Context context_;
    vk::raii::Instance instance_ = make_instance(context_);
    vk::raii::PhysicalDevice physical_;
    std::uint32_t family_;
    vk::raii::Device device_;
    vk::raii::Queue queue_;
    vk::raii::CommandPool pool_;
    vk::raii::Sampler sampler_{device_, vk::SamplerCreateInfo()};
};

// In memory that the CPU sees.
struct Buffer {
    Buffer(const Device& device, std::size_t size, vk::BufferUsageFlags usage)
        : bytes(size),
          handle(device.get(), {{}, size, usage}),
          memory(device.memory(
              handle.getMemoryRequirements(),
              vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent)),
          data((handle.bindMemory(*memory, 0), static_cast<std::byte*>(memory.mapMemory(0, VK_WHOLE_SIZE)))) {
    }

    void fill(const void* contents, std::size_t count) {
        std::memset(data, 0, bytes);
        if (count > 0) std::memcpy(data, contents, count);
    }

    std::size_t bytes;
    vk::raii::Buffer handle;
    vk::raii::DeviceMemory memory;
    std::byte* data;
};

inline constexpr vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
inline constexpr auto general = vk::ImageLayout::eGeneral;

struct Image {
    Image(const Device& device, const gloam_image_info& info, Extent view)
        : extent(info.divisor == 0 ? Extent{info.width, info.height}
                                   : Extent{(view.width + info.divisor - 1) / info.divisor,
                                            (view.height + info.divisor - 1) / info.divisor}),
          handle(device.get(), {{},
                                vk::ImageType::e2D,
                                vk::Format(info.format),
                                {extent.width, extent.height, 1},
                                1,
                                1,
                                vk::SampleCountFlagBits::e1,
                                vk::ImageTiling::eOptimal,
                                vk::ImageUsageFlags(info.usage)}),
          memory(device.memory(handle.getMemoryRequirements(), {})),
          view(make_view(device, vk::Format(info.format))) {
        device.run([&](const vk::raii::CommandBuffer& commands) {
            const vk::ImageMemoryBarrier to_general({}, {}, {}, general, VK_QUEUE_FAMILY_IGNORED,
                                                    VK_QUEUE_FAMILY_IGNORED, *handle, whole);
            commands.pipelineBarrier(vk::PipelineStageFlagBits::eTopOfPipe,
                                     vk::PipelineStageFlagBits::eBottomOfPipe, {}, nullptr, nullptr,
                                     to_general);
        });
    }

    Extent extent;
    vk::raii::Image handle;
    vk::raii::DeviceMemory memory;
    vk::raii::ImageView view;

    vk::BufferImageCopy all_of_it() const {
        return {0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, {extent.width, extent.height, 1}};
    }

  private:
    vk::raii::ImageView make_view(const Device& device, vk::Format format) {
        handle.bindMemory(*memory, 0);
        return {device.get(), {{}, *handle, vk::ImageViewType::e2D, format, {}, whole}};
    }
};

// Everything written before it is seen by everything after it: more than the page's table of barriers asks
// for.
inline void barrier(const vk::raii::CommandBuffer& commands) {
    const auto all = vk::PipelineStageFlagBits::eAllCommands;
    const vk::MemoryBarrier memory(vk::AccessFlagBits::eMemoryWrite,
                                   vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite);
    commands.pipelineBarrier(all, all, {}, memory, nullptr, nullptr);
}
