// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::backend::vulkan {
namespace {

using backend::SampledHeader;
using backend::SampledShape;
using backend::SampledTexel;

bool is_3d(const SampledHeader& header) {
    return header.shape == SampledShape::three;
}

std::uint32_t layers_of(const SampledHeader& header) {
    return is_3d(header) ? 1 : header.depth;
}

bool is_float(SampledTexel texel) {
    return texel == SampledTexel::real || texel == SampledTexel::depth;
}

// In the order of the enumerations. Every device filters halves.
constexpr std::array formats{vk::Format::eR16G16B16A16Sfloat, vk::Format::eR32G32B32A32Sint,
                             vk::Format::eR32G32B32A32Uint, vk::Format::eD32Sfloat};
constexpr std::array comparisons{vk::CompareOp::eLessOrEqual, vk::CompareOp::eGreaterOrEqual,
                                 vk::CompareOp::eLess, vk::CompareOp::eGreater};
constexpr std::array view_types{vk::ImageViewType::e2D, vk::ImageViewType::e2DArray, vk::ImageViewType::e3D,
                                vk::ImageViewType::eCube, vk::ImageViewType::eCubeArray};
constexpr std::array address_modes{vk::SamplerAddressMode::eRepeat, vk::SamplerAddressMode::eMirroredRepeat,
                                   vk::SamplerAddressMode::eClampToEdge,
                                   vk::SamplerAddressMode::eClampToBorder};

vk::ImageAspectFlagBits aspect_of(SampledTexel texel) {
    return texel == SampledTexel::depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

vk::raii::Sampler sampler_of(const Context& context, const SampledHeader& header) {
    const bool linear = header.linear != 0;
    const auto filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
    const auto mode = named(address_modes, header.wrap);
    return {context.device,
            vk::SamplerCreateInfo{
                .magFilter = filter,
                .minFilter = filter,
                .mipmapMode = linear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest,
                .addressModeU = mode,
                .addressModeV = mode,
                .addressModeW = mode,
                .compareEnable = header.texel == SampledTexel::depth ? VK_TRUE : VK_FALSE,
                .compareOp = named(comparisons, header.compare),
                .maxLod = VK_LOD_CLAMP_NONE,
                .borderColor = is_float(header.texel) ? vk::BorderColor::eFloatTransparentBlack
                                                      : vk::BorderColor::eIntTransparentBlack}};
}

vk::ImageCreateInfo info_of(const SampledHeader& header) {
    return {
        .flags = is_cube(header.shape) ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags{},
        .imageType = is_3d(header) ? vk::ImageType::e3D : vk::ImageType::e2D,
        .format = named(formats, header.texel),
        .extent = {header.width, header.height, is_3d(header) ? header.depth : 1},
        .mipLevels = header.levels,
        .arrayLayers = layers_of(header),
        .samples = vk::SampleCountFlagBits::e1,
        .tiling = vk::ImageTiling::eOptimal,
        .usage = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst,
        .initialLayout = vk::ImageLayout::eUndefined};
}

SampledImage::Handles create(Context& context, const SampledHeader& header) {
    context.require_idle();
    if (header.shape == SampledShape::cube_layers &&
        context.physical.handle.getFeatures().imageCubeArray == VK_FALSE)
        throw backend::Unsupported("this device has no samplers of arrays of cubes");
    return {make_image(context, info_of(header), named(view_types, header.shape), aspect_of(header.texel),
                       "a sampled image"),
            sampler_of(context, header)};
}

std::vector<vk::BufferImageCopy> copies_of(const SampledHeader& header) {
    std::vector<vk::BufferImageCopy> copies;
    for (std::uint32_t level = 0; level < header.levels; ++level) {
        const auto [width, height, depth] = backend::size_of_level(header, level);
        copies.push_back({.bufferOffset = backend::texels_before(header, level) *
                                          backend::stored_words(header.texel) * sizeof(backend::Word),
                          .imageSubresource = {.aspectMask = aspect_of(header.texel),
                                               .mipLevel = level,
                                               .layerCount = layers_of(header)},
                          .imageExtent = {width, height, is_3d(header) ? depth : 1}});
    }
    return copies;
}

}  // namespace

SampledImage::SampledImage(const Device& device, std::span<const backend::Word> words)
    : handles(owned(create(device.impl(), backend::sampled_header(words)))) {
    const SampledHeader header = backend::sampled_header(words);
    const std::vector<backend::Word> texels = backend::stored_texels(words);
    const auto staging = owned(make_buffer(handles->context, std::as_bytes(std::span(texels)).size()));
    std::memcpy(staging->mapped.data(), texels.data(), staging->mapped.size());
    handles->context.run_once([&](const vk::raii::CommandBuffer& commands) {
        begin_general_layout(commands, *handles,
                             {.aspectMask = aspect_of(header.texel),
                              .levelCount = header.levels,
                              .layerCount = layers_of(header)});
        commands.copyBufferToImage(*staging->buffer, *handles->image, vk::ImageLayout::eGeneral,
                                   copies_of(header));
    });
}

}  // namespace gloam::backend::vulkan
