// SPDX-License-Identifier: MIT
#include "gpu/internal/render_pass.hpp"

#include <array>

#include "gpu/internal/format.hpp"

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

}  // namespace gloam::gpu
