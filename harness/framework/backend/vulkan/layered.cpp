// SPDX-License-Identifier: MIT
#include <map>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::gpu {
namespace {

constexpr auto color = vk::ImageAspectFlagBits::eColor;

vk::Format format_of(const std::string& name) {
    using F = vk::Format;
    static const std::map<std::string, F> formats{{"r32f", F::eR32Sfloat},
                                                  {"r32i", F::eR32Sint},
                                                  {"r32ui", F::eR32Uint},
                                                  {"rg32f", F::eR32G32Sfloat},
                                                  {"rg32i", F::eR32G32Sint},
                                                  {"rg32ui", F::eR32G32Uint},
                                                  {"rgba32f", F::eR32G32B32A32Sfloat},
                                                  {"rgba32i", F::eR32G32B32A32Sint},
                                                  {"rgba32ui", F::eR32G32B32A32Uint}};
    const auto found = formats.find(name);
    if (found == formats.end())
        throw std::invalid_argument("an image of layers of the format \"" + name +
                                    "\", expected one of 32 bits");
    return found->second;
}

ImageHandles create(Context& context, const LayeredImage::Layers& layers) {
    context.require_idle();
    const vk::Format format = format_of(layers.format);
    const auto features = context.physical.handle.getFormatProperties(format).optimalTilingFeatures;
    if (!(features & vk::FormatFeatureFlagBits::eStorageImage))
        throw backend::Unsupported("this device stores to no image of the format " + layers.format);
    return make_image(context,
                      {.imageType = vk::ImageType::e2D,
                       .format = format,
                       .extent = {layers.width, layers.height, 1},
                       .mipLevels = 1,
                       .arrayLayers = layers.count,
                       .samples = vk::SampleCountFlagBits::e1,
                       .tiling = vk::ImageTiling::eOptimal,
                       .usage = vk::ImageUsageFlagBits::eStorage,
                       .initialLayout = vk::ImageLayout::eUndefined},
                      vk::ImageViewType::e2DArray, color, "an image of layers");
}

}  // namespace

LayeredImage::Impl::Impl(Context& owner, const Layers& layers)
    : context(owner), handles(owner, create(owner, layers)) {
    context.run_once([&](const vk::raii::CommandBuffer& commands) {
        begin_general_layout(commands, *handles->image,
                             {.aspectMask = color, .levelCount = 1, .layerCount = layers.count});
    });
}

LayeredImage::LayeredImage(const Device& device, const Layers& layers)
    : impl_(base::make_hidden<Impl>(device.impl(), layers)) {}

}  // namespace gloam::gpu
