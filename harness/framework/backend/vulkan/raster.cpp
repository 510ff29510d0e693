// SPDX-License-Identifier: MIT
#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::backend::vulkan {
namespace {

constexpr auto raster_stages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

// A pass without images.
vk::raii::RenderPass make_render_pass(const Context& context) {
    const vk::SubpassDescription subpass{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics};
    return {context.device, vk::RenderPassCreateInfo{.subpassCount = 1, .pSubpasses = &subpass}};
}

vk::PipelineShaderStageCreateInfo stage(vk::ShaderStageFlagBits which, const vk::raii::ShaderModule& module,
                                        const Specialization& constants) {
    return {.stage = which, .module = *module, .pName = "main", .pSpecializationInfo = &constants.info};
}

// The pipeline state that does not depend on the program; the run determines viewport and scissor.
struct FixedState {
    vk::PipelineVertexInputStateCreateInfo input{};
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
    const FixedState fixed;
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = fixed.dynamic.size(),
                                                     .pDynamicStates = fixed.dynamic.data()};
    return {context.device, context.cache,
            vk::GraphicsPipelineCreateInfo{.stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &fixed.input,
                                           .pInputAssemblyState = &fixed.assembly,
                                           .pViewportState = &fixed.viewport,
                                           .pRasterizationState = &fixed.rasterization,
                                           .pMultisampleState = &fixed.multisample,
                                           .pDynamicState = &dynamic,
                                           .layout = *layout,
                                           .renderPass = *render_pass}};
}

RasterPipeline::Handles create(Context& context, const RasterProgram& program) {
    auto render_pass = make_render_pass(context);
    auto set_layout = make_set_layout(context, program.bindings, raster_stages);
    auto layout = make_layout(context, set_layout, raster_stages, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, program, render_pass, layout);
    return {context,           program.bindings,   std::move(render_pass), std::move(set_layout),
            std::move(layout), std::move(pipeline)};
}

}  // namespace

RasterPipeline::RasterPipeline(const Device& device, const RasterProgram& program)
    : handles(owned(create(device.impl(), program))) {}

void render(Commands& commands, const RasterPipeline& pipeline, Extent extent,
            std::span<const Resource> resources, std::span<const std::byte> push_constants) {
    const auto& program = *pipeline.handles;
    Commands::Handles& handles = *commands.handles;
    const auto& recording = handles.recording();
    const vk::Rect2D area{.extent = {extent.width, extent.height}};
    handles.framebuffers.emplace_back(
        program.context.device,
        vk::FramebufferCreateInfo{
            .renderPass = *program.render_pass, .width = extent.width, .height = extent.height, .layers = 1});
    recording.beginRenderPass(
        {.renderPass = *program.render_pass, .framebuffer = *handles.framebuffers.back(), .renderArea = area},
        vk::SubpassContents::eInline);
    recording.bindPipeline(vk::PipelineBindPoint::eGraphics, *program.pipeline);
    recording.setViewport(0, vk::Viewport{.width = static_cast<float>(extent.width),
                                          .height = static_cast<float>(extent.height),
                                          .maxDepth = 1.0f});
    recording.setScissor(0, area);
    const auto set = handles.set_of(program.set_layout, program.bindings, resources);
    recording.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *program.layout, 0, set, nullptr);
    recording.pushConstants<std::byte>(*program.layout, raster_stages, 0, push_constants);
    recording.draw(3, 1, 0, 0);
    recording.endRenderPass();
    device_barrier(recording);
}

}  // namespace gloam::backend::vulkan
