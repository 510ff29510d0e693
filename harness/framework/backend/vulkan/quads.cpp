// SPDX-License-Identifier: MIT
// Fragment shaders that run in quads of 2 x 2 pixels, for their effects on buffers: no image is drawn.
#include <array>
#include <stdexcept>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::gpu {

vk::raii::RenderPass make_quad_pass(const Context& context) {
    const vk::SubpassDescription subpass{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics};
    return {context.device, vk::RenderPassCreateInfo{.subpassCount = 1, .pSubpasses = &subpass}};
}

vk::raii::Pipeline make_quad_pipeline(const Context& context, const vk::raii::PipelineLayout& layout,
                                      const vk::raii::RenderPass& render_pass,
                                      const ComputeProgram& program) {
    if (!program.constants.empty())
        throw std::invalid_argument("a fragment shader that runs in quads has no specialization constants");
    const auto vertex = make_module(context, program.vertex_spirv);
    const auto fragment = make_module(context, program.spirv);
    using Stage = vk::ShaderStageFlagBits;
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{.stage = Stage::eVertex, .module = *vertex, .pName = "main"},
        vk::PipelineShaderStageCreateInfo{.stage = Stage::eFragment, .module = *fragment, .pName = "main"}};
    const vk::PipelineVertexInputStateCreateInfo no_attributes;
    const vk::PipelineInputAssemblyStateCreateInfo triangles{.topology =
                                                                 vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo rasterization{
        .polygonMode = vk::PolygonMode::eFill, .cullMode = vk::CullModeFlagBits::eNone, .lineWidth = 1.0F};
    const vk::PipelineMultisampleStateCreateInfo multisample{.rasterizationSamples =
                                                                 vk::SampleCountFlagBits::e1};
    const std::array dynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo state{.dynamicStateCount = dynamic.size(),
                                                   .pDynamicStates = dynamic.data()};
    return {context.device, context.cache.handle(),
            vk::GraphicsPipelineCreateInfo{.stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &no_attributes,
                                           .pInputAssemblyState = &triangles,
                                           .pViewportState = &viewport,
                                           .pRasterizationState = &rasterization,
                                           .pMultisampleState = &multisample,
                                           .pDynamicState = &state,
                                           .layout = *layout,
                                           .renderPass = *render_pass}};
}

void Commands::Impl::draw_quads(const ComputePipeline::Impl& pipeline, std::uint32_t columns,
                                std::uint32_t rows) {
    constexpr std::uint32_t side = 2;  // of a quad, in pixels
    constexpr std::uint32_t corners = 3;
    if (columns == 0 || rows == 0) return;
    const auto& limits = context.physical.properties.limits;
    if (columns > limits.maxFramebufferWidth / side || rows > limits.maxFramebufferHeight / side)
        throw std::invalid_argument(fmt::format("dispatch: {} x {} quads, device \"{}\" allows {} x {}",
                                                columns, rows, context.physical.info.name,
                                                limits.maxFramebufferWidth / side,
                                                limits.maxFramebufferHeight / side));
    const vk::Rect2D area{{0, 0}, {columns * side, rows * side}};
    handles->framebuffers.emplace_back(context.device,
                                       vk::FramebufferCreateInfo{.renderPass = *pipeline.handles->render_pass,
                                                                 .width = area.extent.width,
                                                                 .height = area.extent.height,
                                                                 .layers = 1});
    const auto& commands = recording();
    commands.beginRenderPass({.renderPass = *pipeline.handles->render_pass,
                              .framebuffer = *handles->framebuffers.back(),
                              .renderArea = area},
                             vk::SubpassContents::eInline);
    // The triangle is half of the viewport, so that nothing clips it: where it is divided, a quad on the seam
    // runs twice, with half of its invocations each time.
    commands.setViewport(0, vk::Viewport{.width = 2.0F * static_cast<float>(area.extent.width),
                                         .height = 2.0F * static_cast<float>(area.extent.height),
                                         .maxDepth = 1.0F});
    commands.setScissor(0, area);
    commands.draw(corners, 1, 0, 0);
    commands.endRenderPass();
}

}  // namespace gloam::gpu
