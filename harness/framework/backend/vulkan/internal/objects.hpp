// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/vulkan.hpp"
#include "backend/vulkan/resources.hpp"

namespace gloam::gpu {

// How a copy keeps a channel: 32 bits as they are; float16; integers of 16 bits; steps of 1/255.
enum class TexelKind { words, halves, shorts, unorm8 };

// Properties of a Format for Vulkan and for copies.
struct FormatTraits {
    std::string_view name;
    vk::Format format;
    int channels;
    std::size_t texel_bytes;
    TexelKind kind;
};

[[nodiscard]] const FormatTraits& traits(Format format);

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

struct LayeredImage::Handles : ImageHandles {};

struct ComputePipeline::Handles {
    Context& context;
    PipelineProgram program;
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

constexpr std::size_t binding_kinds = 4;

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

// Descriptor sets for one recording, from pools that are added on demand.
class DescriptorAllocator {
  public:
    // A set with this layout, which has the given number of bindings of each kind.
    [[nodiscard]] const vk::raii::DescriptorSet& allocate(const Context& context,
                                                          const vk::raii::DescriptorSetLayout& layout,
                                                          std::span<const BindingKind> bindings);

  private:
    using Counts = std::array<std::uint32_t, binding_kinds>;  // of descriptors, by kind
    void add_pool(const Context& context, const Counts& needed);

    std::uint32_t sets_left_ = 0;
    Counts left_{};
    std::vector<vk::raii::DescriptorPool> pools_;
    std::vector<vk::raii::DescriptorSet> sets_;  // declared after the pools, so that they are destroyed first
};

// Binds resources[i] to binding i of the set. bindings: the kinds of the set's layout, which the resources
// fit.
void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const BindingKind> bindings, std::span<const Resource> resources);

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
    // Throws std::runtime_error after submit().
    [[nodiscard]] const vk::raii::CommandBuffer& recording() const;

    enum class State { recording, submitted, finished };
    Context& context;
    vk::raii::CommandBuffers buffers;
    DescriptorAllocator descriptors{};
    Timestamps timestamps{};
    std::vector<vk::raii::Framebuffer> framebuffers{};
    State state = State::recording;
};

}  // namespace gloam::gpu
