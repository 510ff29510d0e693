// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/vulkan.hpp"
#include "backend/vulkan/resources.hpp"

namespace gloam::backend::vulkan {

struct Buffer::Handles {
    Context& context;
    vk::raii::Buffer buffer;
    vk::raii::DeviceMemory memory;
    std::span<std::byte> mapped;
};
[[nodiscard]] Buffer::Handles make_buffer(Context& context, std::size_t bytes);

// In VK_IMAGE_LAYOUT_GENERAL, as soon as they are made.
struct ImageHandles {
    Context& context;
    vk::raii::Image image;
    vk::raii::DeviceMemory memory;
    vk::raii::ImageView view;
};

// An image in the device's memory, and a view of all of it. The purpose is for messages.
[[nodiscard]] ImageHandles make_image(Context& context, const vk::ImageCreateInfo& info,
                                      vk::ImageViewType type, vk::ImageAspectFlags aspect,
                                      const std::string& purpose);

// Records that a new image has VK_IMAGE_LAYOUT_GENERAL from here on. `all_of_it`: all of its levels and
// layers.
void begin_general_layout(const vk::raii::CommandBuffer& commands, const ImageHandles& image,
                          const vk::ImageSubresourceRange& all_of_it);

struct Image::Handles : ImageHandles {
    Extent extent;
    Format format;
    std::vector<vk::raii::ImageView> levels;  // a view of each
};

struct SampledImage::Handles : ImageHandles {
    vk::raii::Sampler sampler;
};

struct ComputePipeline::Handles {
    Context& context;
    std::vector<BindingKind> bindings;
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

// The constants of a stage, which must outlive it.
struct Specialization {
    explicit Specialization(std::span<const SpecializationConstant> constants);
    std::vector<vk::SpecializationMapEntry> entries;
    vk::SpecializationInfo info;
};

// Binding i of the set has kinds[i]. Throws std::invalid_argument where they exceed the device's limits.
[[nodiscard]] vk::raii::DescriptorSetLayout make_set_layout(const Context& context,
                                                            std::span<const BindingKind> kinds,
                                                            vk::ShaderStageFlags stages);

struct RasterPipeline::Handles {
    Context& context;
    std::vector<BindingKind> bindings;
    vk::raii::RenderPass render_pass;
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

// What must outlive the execution of a recording.
struct Commands::Handles {
    [[nodiscard]] const vk::raii::CommandBuffer& recording() const { return buffers.front(); }
    // A descriptor set with this layout, from a pool of its own: binding i has kinds[i] and resources[i].
    [[nodiscard]] vk::DescriptorSet set_of(const vk::raii::DescriptorSetLayout& layout,
                                           std::span<const BindingKind> kinds,
                                           std::span<const Resource> resources);
    void bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
              std::span<const std::byte> push_constants);

    Context& context;
    vk::raii::CommandBuffers buffers;
    std::vector<vk::raii::DescriptorPool> pools{};
    std::vector<vk::raii::DescriptorSet> sets{};  // behind the pools, so that they are destroyed first
    std::size_t readings = 0;                     // of the device's clock
    std::vector<vk::raii::QueryPool> queries{};
    std::vector<vk::raii::Framebuffer> framebuffers{};
};

}  // namespace gloam::backend::vulkan
