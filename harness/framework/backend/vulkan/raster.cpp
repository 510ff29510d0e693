// SPDX-License-Identifier: MIT
#include "backend/vulkan/commands.hpp"

#include <algorithm>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::gpu {
namespace {

vk::AttachmentDescription cleared(Format format) {
    return {.format = traits(format).format,
            .samples = vk::SampleCountFlagBits::e1,
            .loadOp = vk::AttachmentLoadOp::eClear,
            .storeOp = vk::AttachmentStoreOp::eStore,
            .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
            .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
            .initialLayout = vk::ImageLayout::eUndefined,
            .finalLayout = vk::ImageLayout::eGeneral};
}

// The layout transitions at both ends must wait for earlier commands and precede later ones.
std::array<vk::SubpassDependency, 2> dependencies() {
    using Access = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    constexpr auto any = Access::eMemoryRead | Access::eMemoryWrite;
    return {vk::SubpassDependency{.srcSubpass = VK_SUBPASS_EXTERNAL,
                                  .dstSubpass = 0,
                                  .srcStageMask = Stage::eAllCommands,
                                  .dstStageMask = Stage::eAllGraphics,
                                  .srcAccessMask = Access::eMemoryWrite,
                                  .dstAccessMask = any},
            vk::SubpassDependency{.srcSubpass = 0,
                                  .dstSubpass = VK_SUBPASS_EXTERNAL,
                                  .srcStageMask = Stage::eAllGraphics,
                                  .dstStageMask = Stage::eAllCommands,
                                  .srcAccessMask = Access::eMemoryWrite,
                                  .dstAccessMask = any}};
}

}  // namespace

vk::raii::RenderPass make_render_pass(const Context& context, std::span<const Format> color_formats) {
    std::vector<vk::AttachmentDescription> attachments;
    std::vector<vk::AttachmentReference> colors;
    for (const auto format : color_formats) {
        colors.push_back({.attachment = static_cast<std::uint32_t>(attachments.size()),
                          .layout = vk::ImageLayout::eColorAttachmentOptimal});
        attachments.push_back(cleared(format));
    }
    const vk::AttachmentReference depth{.attachment = static_cast<std::uint32_t>(attachments.size()),
                                        .layout = vk::ImageLayout::eDepthStencilAttachmentOptimal};
    attachments.push_back(cleared(Format::depth32f));
    const vk::SubpassDescription subpass{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics,
                                         .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                                         .pColorAttachments = colors.data(),
                                         .pDepthStencilAttachment = &depth};
    const auto order = dependencies();
    return {context.device,
            vk::RenderPassCreateInfo{.attachmentCount = static_cast<std::uint32_t>(attachments.size()),
                                     .pAttachments = attachments.data(),
                                     .subpassCount = 1,
                                     .pSubpasses = &subpass,
                                     .dependencyCount = static_cast<std::uint32_t>(order.size()),
                                     .pDependencies = order.data()}};
}

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
        layout.attributes.push_back({.location = static_cast<std::uint32_t>(layout.attributes.size()),
                                     .format = formats.at(static_cast<std::size_t>(size - 1)),
                                     .offset = layout.stride});
        layout.stride += static_cast<std::uint32_t>(size) * 4;
    }
    return layout;
}

vk::PipelineShaderStageCreateInfo stage(vk::ShaderStageFlagBits which, const vk::raii::ShaderModule& module,
                                        const Specialization& constants) {
    return {.stage = which, .module = *module, .pName = "main", .pSpecializationInfo = &constants.info};
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
    const Specialization constants(program.constants);
    const std::array stages{stage(vk::ShaderStageFlagBits::eVertex, vertex, constants),
                            stage(vk::ShaderStageFlagBits::eFragment, fragment, constants)};
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
    auto render_pass = make_render_pass(context, program.color_formats);
    auto set_layout = make_set_layout(context, program.bindings, raster_stages);
    auto layout = make_layout(context, set_layout, raster_stages, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, program, render_pass, layout);
    return {std::move(render_pass), std::move(set_layout), std::move(layout), std::move(pipeline)};
}

}  // namespace

RasterPipeline::Impl::Impl(Context& owner, const RasterProgram& program)
    : context(owner),
      color_images(program.color_formats.size()),
      reversed_z(program.reversed_z),
      bindings(program.bindings),
      handles(owner, create(owner, program)) {}

RasterPipeline::RasterPipeline(const Device& device, const RasterProgram& program)
    : impl_(base::make_hidden<Impl>(device.impl(), program)) {}

namespace {

using Images = std::span<const std::reference_wrapper<const Image>>;

vk::raii::Framebuffer make_framebuffer(const RasterPipeline::Impl& pipeline, Images colors,
                                       const Image& depth) {
    std::vector<vk::ImageView> views;
    for (const Image& image : colors) views.push_back(*image.impl().handles->view);
    views.push_back(*depth.impl().handles->view);
    return {pipeline.context.device,
            vk::FramebufferCreateInfo{.renderPass = *pipeline.handles->render_pass,
                                      .attachmentCount = static_cast<std::uint32_t>(views.size()),
                                      .pAttachments = views.data(),
                                      .width = depth.extent().width,
                                      .height = depth.extent().height,
                                      .layers = 1}};
}

void begin_pass(const vk::raii::CommandBuffer& commands, const RasterPipeline::Impl& pipeline,
                const vk::raii::Framebuffer& framebuffer, Extent extent, float clear_color) {
    const vk::ClearValue color{.color = {.float32 = {{clear_color, clear_color, clear_color, clear_color}}}};
    std::vector<vk::ClearValue> clear(pipeline.color_images, color);
    clear.push_back({.depthStencil = {.depth = pipeline.reversed_z ? 0.0f : 1.0f}});
    const vk::Rect2D area{.extent = {extent.width, extent.height}};
    commands.beginRenderPass(
        vk::RenderPassBeginInfo{.renderPass = *pipeline.handles->render_pass,
                                .framebuffer = *framebuffer,
                                .renderArea = area,
                                .clearValueCount = static_cast<std::uint32_t>(clear.size()),
                                .pClearValues = clear.data()},
        vk::SubpassContents::eInline);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handles->pipeline);
    commands.setViewport(0, vk::Viewport{.width = static_cast<float>(extent.width),
                                         .height = static_cast<float>(extent.height),
                                         .maxDepth = 1.0f});
    commands.setScissor(0, area);
}

void bind_resources(Recording& handles, const vk::raii::CommandBuffer& commands,
                    const RasterPipeline::Impl& pipeline, const Draw& draw) {
    if (draw.resources.empty()) return;
    const auto& set =
        handles.descriptors.allocate(pipeline.context, pipeline.handles->set_layout, pipeline.bindings);
    write_descriptors(pipeline.context, set, pipeline.bindings, draw.resources);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *pipeline.handles->layout, 0, *set,
                                nullptr);
}

void record_draw(const vk::raii::CommandBuffer& commands, const RasterPipeline::Impl& pipeline,
                 const Draw& draw) {
    commands.bindVertexBuffers(0, *draw.vertices.get().impl().handles->buffer, vk::DeviceSize{0});
    commands.bindIndexBuffer(*draw.indices.get().impl().handles->buffer, 0, vk::IndexType::eUint32);
    if (!draw.push_constants.empty()) {
        commands.pushConstants<std::byte>(*pipeline.handles->layout, raster_stages, 0, draw.push_constants);
    }
    commands.drawIndexed(draw.index_count, 1, 0, 0, 0);
}

}  // namespace

void render(Commands& commands, const RasterPipeline& pipeline, Images colors, const Image& depth,
            float clear_color, std::span<const Draw> draws) {
    const auto& program = pipeline.impl();
    const auto& recording = commands.impl().recording();
    auto& framebuffers = commands.impl().handles->framebuffers;
    framebuffers.push_back(make_framebuffer(program, colors, depth));
    begin_pass(recording, program, framebuffers.back(), depth.extent(), clear_color);
    for (const auto& draw : draws) {
        bind_resources(*commands.impl().handles, recording, program, draw);
        record_draw(recording, program, draw);
    }
    recording.endRenderPass();
    device_barrier(recording);
}

}  // namespace gloam::gpu
