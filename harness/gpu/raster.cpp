// SPDX-License-Identifier: MIT
#include "gpu/raster.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "gpu/internal/raster_impl.hpp"
#include "gpu/internal/render_pass.hpp"
#include "gpu/internal/shader_module.hpp"

namespace gloam::gpu {
namespace {

// Vertex attributes in Vulkan's form, and their total size.
struct VertexLayout {
    std::vector<vk::VertexInputAttributeDescription> attributes;
    std::uint32_t stride = 0;
};

VertexLayout vertex_layout(std::span<const int> sizes) {
    constexpr std::array formats{vk::Format::eR32Sfloat, vk::Format::eR32G32Sfloat,
                                 vk::Format::eR32G32B32Sfloat, vk::Format::eR32G32B32A32Sfloat};
    VertexLayout layout;
    for (const int size : sizes) {
        if (size < 1 || size > 4) {
            throw std::invalid_argument(
                fmt::format("raster pipeline: attribute of {} floats, expected 1 to 4", size));
        }
        layout.attributes.push_back({.location = static_cast<std::uint32_t>(layout.attributes.size()),
                                     .format = formats[static_cast<std::size_t>(size - 1)],
                                     .offset = layout.stride});
        layout.stride += static_cast<std::uint32_t>(size) * 4;
    }
    return layout;
}

void check_limit(std::size_t count, std::uint32_t limit, const char* what) {
    if (count > limit) {
        throw std::invalid_argument(
            fmt::format("raster pipeline with {} {}: the device allows {}", count, what, limit));
    }
}

void check(const Context& context, const RasterProgram& program) {
    const auto& limits = context.physical.properties.limits;
    check_limit(program.attribute_sizes.size(), limits.maxVertexInputAttributes, "vertex attributes");
    check_limit(program.color_formats.size(),
                std::min(limits.maxColorAttachments, limits.maxFragmentOutputAttachments), "colour images");
    check_limit(program.image_count, limits.maxPerStageDescriptorStorageImages, "images to read");
    check_push_constant_size(context, program.push_constant_bytes);
    if (std::ranges::count(program.color_formats, Format::depth32f) > 0) {
        throw std::invalid_argument("raster pipeline: depth32f among the colour formats");
    }
}

vk::raii::DescriptorSetLayout make_image_layout(const Context& context, std::uint32_t images) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < images; ++i) {
        bindings.push_back({.binding = i,
                            .descriptorType = vk::DescriptorType::eStorageImage,
                            .descriptorCount = 1,
                            .stageFlags = vk::ShaderStageFlagBits::eFragment});
    }
    return {context.device,
            vk::DescriptorSetLayoutCreateInfo{.bindingCount = images, .pBindings = bindings.data()}};
}

vk::raii::PipelineLayout make_raster_layout(const Context& context,
                                            const vk::raii::DescriptorSetLayout& set_layout,
                                            std::uint32_t push_constant_bytes) {
    const vk::PushConstantRange range{.stageFlags = raster_stages, .size = push_constant_bytes};
    return {context.device,
            vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                         .pSetLayouts = &*set_layout,
                                         .pushConstantRangeCount = push_constant_bytes > 0 ? 1u : 0u,
                                         .pPushConstantRanges = &range}};
}

vk::PipelineShaderStageCreateInfo stage(vk::ShaderStageFlagBits which, const vk::raii::ShaderModule& module) {
    return {.stage = which, .module = *module, .pName = "main"};
}

vk::PipelineDepthStencilStateCreateInfo depth_test(bool reversed_z) {
    return {.depthTestEnable = VK_TRUE,
            .depthWriteEnable = VK_TRUE,
            .depthCompareOp = reversed_z ? vk::CompareOp::eGreater : vk::CompareOp::eLess};
}

std::vector<vk::PipelineColorBlendAttachmentState> no_blending(std::size_t images) {
    using Component = vk::ColorComponentFlagBits;
    return {images, vk::PipelineColorBlendAttachmentState{.colorWriteMask = Component::eR | Component::eG |
                                                                            Component::eB | Component::eA}};
}

// The pipeline state that does not depend on the program; the images determine viewport and scissor.
struct FixedState {
    vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    vk::PipelineRasterizationStateCreateInfo rasterization{
        .polygonMode = vk::PolygonMode::eFill, .cullMode = vk::CullModeFlagBits::eNone, .lineWidth = 1.0f};
    vk::PipelineMultisampleStateCreateInfo multisample{.rasterizationSamples = vk::SampleCountFlagBits::e1};
    std::array<vk::DynamicState, 2> dynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
};

vk::raii::Pipeline make_pipeline(const Context& context, const RasterProgram& program,
                                 const vk::raii::RenderPass& render_pass,
                                 const vk::raii::PipelineLayout& layout) {
    const auto vertex = make_module(context, program.vertex_spirv);
    const auto fragment = make_module(context, program.fragment_spirv);
    const std::array stages{stage(vk::ShaderStageFlagBits::eVertex, vertex),
                            stage(vk::ShaderStageFlagBits::eFragment, fragment)};
    const auto vertices = vertex_layout(program.attribute_sizes);
    const vk::VertexInputBindingDescription binding{.stride = vertices.stride};
    const auto attributes = static_cast<std::uint32_t>(vertices.attributes.size());
    const vk::PipelineVertexInputStateCreateInfo input{
        .vertexBindingDescriptionCount = attributes > 0 ? 1u : 0u,
        .pVertexBindingDescriptions = &binding,
        .vertexAttributeDescriptionCount = attributes,
        .pVertexAttributeDescriptions = vertices.attributes.data()};
    const FixedState fixed;
    const auto depth = depth_test(program.reversed_z);
    const auto blending = no_blending(program.color_formats.size());
    const vk::PipelineColorBlendStateCreateInfo blend{
        .attachmentCount = static_cast<std::uint32_t>(blending.size()), .pAttachments = blending.data()};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = fixed.dynamic.size(),
                                                     .pDynamicStates = fixed.dynamic.data()};
    return {context.device, context.cache.handle(),
            vk::GraphicsPipelineCreateInfo{.stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &input,
                                           .pInputAssemblyState = &fixed.assembly,
                                           .pViewportState = &fixed.viewport,
                                           .pRasterizationState = &fixed.rasterization,
                                           .pMultisampleState = &fixed.multisample,
                                           .pDepthStencilState = &depth,
                                           .pColorBlendState = &blend,
                                           .pDynamicState = &dynamic,
                                           .layout = *layout,
                                           .renderPass = *render_pass}};
}

RasterHandles create(const Context& context, const RasterProgram& program) {
    check(context, program);
    auto render_pass = make_render_pass(context, program.color_formats);
    auto set_layout = make_image_layout(context, program.image_count);
    auto layout = make_raster_layout(context, set_layout, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, program, render_pass, layout);
    return {std::move(render_pass), std::move(set_layout), std::move(layout), std::move(pipeline)};
}

}  // namespace

RasterPipeline::Impl::Impl(Context& owner, const RasterProgram& program)
    : context(owner),
      color_formats(program.color_formats),
      push_constant_bytes(program.push_constant_bytes),
      reversed_z(program.reversed_z),
      image_count(program.image_count),
      handles(owner, create(owner, program)) {}

RasterPipeline::RasterPipeline(const Device& device, const RasterProgram& program)
    : impl_(std::make_unique<Impl>(device.impl(), program)) {}
RasterPipeline::~RasterPipeline() = default;
RasterPipeline::RasterPipeline(RasterPipeline&&) noexcept = default;
RasterPipeline& RasterPipeline::operator=(RasterPipeline&&) noexcept = default;

}  // namespace gloam::gpu
