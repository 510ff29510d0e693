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

struct BufferHandles {
    vk::raii::Buffer buffer;
    vk::raii::DeviceMemory memory;
};

struct Buffer::Impl {
    Impl(Context& owner, std::size_t bytes);

    Context& context;
    Guarded<BufferHandles> handles;
    std::span<std::byte> mapped;
};

struct ImageHandles {
    vk::raii::Image image;
    vk::raii::DeviceMemory memory;
    vk::raii::ImageView view;
};

// An image in the device's memory, and a view of all of it. The purpose is for messages.
[[nodiscard]] ImageHandles make_image(const Context& context, const vk::ImageCreateInfo& info,
                                      vk::ImageViewType type, vk::ImageAspectFlags aspect,
                                      const std::string& purpose);

// The image is in VK_IMAGE_LAYOUT_GENERAL whenever no render pass uses it.
struct Image::Impl {
    Impl(Context& owner, Extent size, Format kind, std::uint32_t level_count);

    Context& context;
    Extent extent;
    Format format;
    Guarded<ImageHandles> handles;
    Guarded<std::vector<vk::raii::ImageView>> levels;  // a view of each
};

// Records that a new image has VK_IMAGE_LAYOUT_GENERAL from here on. `all_of_it`: all of its levels and
// layers.
void begin_general_layout(const vk::raii::CommandBuffer& commands, vk::Image image,
                          const vk::ImageSubresourceRange& all_of_it);

struct SampledHandles : ImageHandles {
    vk::raii::Sampler sampler;
};

// In VK_IMAGE_LAYOUT_GENERAL.
struct SampledImage::Impl {
    Impl(Context& owner, std::span<const backend::Word> words);

    Context& context;
    Guarded<SampledHandles> handles;
};

// In VK_IMAGE_LAYOUT_GENERAL.
struct LayeredImage::Impl {
    Impl(Context& owner, const Layers& layers);

    Context& context;
    Guarded<ImageHandles> handles;
};

struct ComputeHandles {
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

struct ComputePipeline::Impl {
    Impl(Context& owner, const ComputeProgram& program);

    Context& context;
    std::vector<BindingKind> bindings;
    PipelineProgram program;
    Guarded<ComputeHandles> handles;
};

constexpr std::size_t binding_kinds = 4;

[[nodiscard]] vk::DescriptorType descriptor_type(BindingKind kind);
[[nodiscard]] const char* name_of(BindingKind kind);

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
    [[nodiscard]] const vk::raii::DescriptorSet& allocate(const ComputePipeline::Impl& pipeline);

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

struct RasterHandles {
    vk::raii::RenderPass render_pass;
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

struct RasterPipeline::Impl {
    Impl(Context& owner, const RasterProgram& program);

    Context& context;
    std::vector<BindingKind> bindings;
    Guarded<RasterHandles> handles;
};

// The objects that must outlive the execution of a recording.
struct Recording {
    vk::raii::CommandBuffers buffers;
    DescriptorAllocator descriptors;
    Timestamps timestamps;
    std::vector<vk::raii::Framebuffer> framebuffers;
};

struct Commands::Impl {
    explicit Impl(Context& owner);

    // The command buffer. Throws std::runtime_error after submit().
    [[nodiscard]] const vk::raii::CommandBuffer& recording() const;

    // Records the pipeline, its resources and its push constants.
    void bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
              std::span<const std::byte> push_constants);

    enum class State { recording, submitted, finished };
    Context& context;
    Guarded<Recording> handles;
    State state = State::recording;
};

}  // namespace gloam::gpu
