// SPDX-License-Identifier: MIT
#include "gpu/image.hpp"

#include <stdexcept>

#include "gpu/internal/image_impl.hpp"
#include "gpu/internal/memory.hpp"

namespace gloam::gpu {
namespace {

std::string describe(Extent extent, Format format) {
    return fmt::format("image of {}x{} {}", extent.width, extent.height, traits(format).name);
}

vk::ImageCreateInfo create_info(Extent extent, Format format) {
    constexpr auto copies = vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst;
    return {.imageType = vk::ImageType::e2D,
            .format = traits(format).format,
            .extent = {extent.width, extent.height, 1},
            .mipLevels = 1,
            .arrayLayers = 1,
            .samples = vk::SampleCountFlagBits::e1,
            .tiling = vk::ImageTiling::eOptimal,
            .usage = traits(format).usage | copies,
            .initialLayout = vk::ImageLayout::eUndefined};
}

vk::ImageFormatProperties limits(const Context& context, const vk::ImageCreateInfo& info, Format format) {
    try {
        return context.physical.handle.getImageFormatProperties(info.format, info.imageType, info.tiling,
                                                                info.usage);
    } catch (const vk::FormatNotSupportedError&) {
        throw std::runtime_error(
            fmt::format("device \"{}\" has no {} images", context.physical.info.name, traits(format).name));
    }
}

void check_size(const Context& context, Extent extent, Format format) {
    const auto& device = context.physical.info;
    const auto fits = [&](std::uint32_t side) { return side >= 1 && side <= device.max_image_size; };
    if (!fits(extent.width) || !fits(extent.height)) {
        throw std::runtime_error(fmt::format("{}: device \"{}\" allows sides of 1 to {}",
                                             describe(extent, format), device.name, device.max_image_size));
    }
    const auto bytes = std::uint64_t{extent.width} * extent.height * traits(format).texel_bytes;
    const auto most = limits(context, create_info(extent, format), format).maxResourceSize;
    if (bytes > most) {
        throw std::runtime_error(fmt::format("{}: {} bytes, device \"{}\" allows {}",
                                             describe(extent, format), bytes, device.name, most));
    }
}

ImageHandles create(Context& context, Extent extent, Format format) {
    context.require_idle();  // a driver may wait for the work before it makes an image
    check_size(context, extent, format);
    vk::raii::Image image(context.device, create_info(extent, format));
    auto memory = allocate(context, image.getMemoryRequirements(),
                           {vk::MemoryPropertyFlagBits::eDeviceLocal, {}}, describe(extent, format));
    image.bindMemory(*memory, 0);
    vk::raii::ImageView view(
        context.device,
        vk::ImageViewCreateInfo{
            .image = *image,
            .viewType = vk::ImageViewType::e2D,
            .format = traits(format).format,
            .subresourceRange = {.aspectMask = traits(format).aspect, .levelCount = 1, .layerCount = 1}});
    return {std::move(image), std::move(memory), std::move(view)};
}

}  // namespace

Image::Impl::Impl(Context& owner, Extent size, Format kind)
    : context(owner), extent(size), format(kind), handles(owner, create(owner, size, kind)) {
    context.run_once([this](const vk::raii::CommandBuffer& commands) {
        constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
        using Access = vk::AccessFlagBits;
        const vk::ImageMemoryBarrier barrier{
            .dstAccessMask = Access::eMemoryRead | Access::eMemoryWrite,
            .oldLayout = vk::ImageLayout::eUndefined,
            .newLayout = vk::ImageLayout::eGeneral,
            .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .image = *handles->image,
            .subresourceRange = {.aspectMask = traits(format).aspect, .levelCount = 1, .layerCount = 1}};
        commands.pipelineBarrier(all, all, {}, nullptr, nullptr, barrier);
    });
}

Image::Image(const Device& device, Extent extent, Format format)
    : impl_(std::make_unique<Impl>(device.impl(), extent, format)) {}
Image::~Image() = default;
Image::Image(Image&&) noexcept = default;
Image& Image::operator=(Image&&) noexcept = default;

Extent Image::extent() const {
    return impl_->extent;
}
Format Image::format() const {
    return impl_->format;
}

}  // namespace gloam::gpu
