// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "gpu/internal/barrier.hpp"
#include "gpu/internal/buffer_impl.hpp"
#include "gpu/internal/commands_impl.hpp"
#include "gpu/internal/image_impl.hpp"
#include "gpu/internal/raster_impl.hpp"

namespace gloam::gpu {
namespace {

using Images = std::span<const std::reference_wrapper<const Image>>;

void check_image(const RasterPipeline::Impl& pipeline, const Image& image, Format wanted, Extent extent,
                 const std::string& which) {
    check_same_device(image.impl().context, pipeline.context, "render: an image");
    if (image.format() != wanted) {
        throw std::invalid_argument(fmt::format("render: {} is {}, the pipeline renders to {}", which,
                                                traits(image.format()).name, traits(wanted).name));
    }
    if (image.extent() != extent) {
        throw std::invalid_argument(fmt::format("render: {} is {}x{}, the depth image {}x{}", which,
                                                image.extent().width, image.extent().height, extent.width,
                                                extent.height));
    }
}

void check_images(const RasterPipeline::Impl& pipeline, Images colors, const Image& depth) {
    if (colors.size() != pipeline.color_formats.size()) {
        throw std::invalid_argument(fmt::format("render: {} colour images, the pipeline renders to {}",
                                                colors.size(), pipeline.color_formats.size()));
    }
    check_image(pipeline, depth, Format::depth32f, depth.extent(), "the depth image");
    for (std::size_t i = 0; i < colors.size(); ++i) {
        check_image(pipeline, colors[i], pipeline.color_formats[i], depth.extent(),
                    fmt::format("colour image {}", i));
    }
}

void check_draw(const RasterPipeline::Impl& pipeline, const Draw& draw) {
    check_same_device(draw.vertices.get().impl().context, pipeline.context, "render: a vertex buffer");
    check_same_device(draw.indices.get().impl().context, pipeline.context, "render: an index buffer");
    const auto available = draw.indices.get().size() / sizeof(std::uint32_t);
    if (draw.index_count > available) {
        throw std::invalid_argument(
            fmt::format("render: {} indices, the index buffer holds {}", draw.index_count, available));
    }
    if (draw.push_constants.size() != pipeline.push_constant_bytes) {
        throw std::invalid_argument(fmt::format("render: {} bytes of push constants, the pipeline has {}",
                                                draw.push_constants.size(), pipeline.push_constant_bytes));
    }
    if (draw.images.size() != pipeline.image_count) {
        throw std::invalid_argument(fmt::format("render: {} images to read, the pipeline reads {}",
                                                draw.images.size(), pipeline.image_count));
    }
    for (const Image& image : draw.images) {
        check_same_device(image.impl().context, pipeline.context, "render: an image to read");
        if (image.format() == Format::depth32f)
            throw std::invalid_argument("render: an image to read is depth32f, expected a colour format");
    }
}

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
    std::vector<vk::ClearValue> clear(pipeline.color_formats.size(), color);
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

void bind_images(Recording& handles, const vk::raii::CommandBuffer& commands,
                 const RasterPipeline::Impl& pipeline, const Draw& draw) {
    if (draw.images.empty()) return;
    const std::vector<BindingKind> kinds(pipeline.image_count, BindingKind::storage_image);
    const auto& set = handles.descriptors.allocate(pipeline.context, pipeline.handles->set_layout, kinds);
    const std::vector<Resource> resources(draw.images.begin(), draw.images.end());
    write_descriptors(pipeline.context, set, kinds, resources);
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
    check_same_device(program.context, commands.impl().context, "render: the pipeline");
    check_images(program, colors, depth);
    for (const auto& draw : draws) check_draw(program, draw);

    auto& framebuffers = commands.impl().handles->framebuffers;
    framebuffers.push_back(make_framebuffer(program, colors, depth));
    begin_pass(recording, program, framebuffers.back(), depth.extent(), clear_color);
    for (const auto& draw : draws) {
        bind_images(*commands.impl().handles, recording, program, draw);
        record_draw(recording, program, draw);
    }
    recording.endRenderPass();
    device_barrier(recording);
}

}  // namespace gloam::gpu
