// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::gpu {
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

vk::Format format_of(SampledTexel texel) {
    switch (texel) {
        case SampledTexel::integer:
            return vk::Format::eR32G32B32A32Sint;
        case SampledTexel::natural:
            return vk::Format::eR32G32B32A32Uint;
        case SampledTexel::depth:
            return vk::Format::eD32Sfloat;
        default:
            return vk::Format::eR16G16B16A16Sfloat;  // every device filters it
    }
}

vk::ImageAspectFlagBits aspect_of(SampledTexel texel) {
    return texel == SampledTexel::depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

vk::ImageType image_type(SampledShape shape) {
    return shape == SampledShape::three ? vk::ImageType::e3D : vk::ImageType::e2D;
}

vk::CompareOp compare_op(backend::Compare compare) {
    switch (compare) {
        case backend::Compare::greater_equal:
            return vk::CompareOp::eGreaterOrEqual;
        case backend::Compare::less:
            return vk::CompareOp::eLess;
        case backend::Compare::greater:
            return vk::CompareOp::eGreater;
        default:
            return vk::CompareOp::eLessOrEqual;
    }
}

vk::ImageViewType view_type(SampledShape shape) {
    switch (shape) {
        case SampledShape::layers:
            return vk::ImageViewType::e2DArray;
        case SampledShape::three:
            return vk::ImageViewType::e3D;
        case SampledShape::cube:
            return vk::ImageViewType::eCube;
        case SampledShape::cube_layers:
            return vk::ImageViewType::eCubeArray;
        default:
            return vk::ImageViewType::e2D;
    }
}

vk::SamplerAddressMode address_mode(backend::Wrap wrap) {
    switch (wrap) {
        case backend::Wrap::mirrored:
            return vk::SamplerAddressMode::eMirroredRepeat;
        case backend::Wrap::edge:
            return vk::SamplerAddressMode::eClampToEdge;
        case backend::Wrap::border:
            return vk::SamplerAddressMode::eClampToBorder;
        default:
            return vk::SamplerAddressMode::eRepeat;
    }
}

vk::raii::Sampler sampler_of(const Context& context, const SampledHeader& header) {
    const bool linear = header.linear != 0;
    const auto filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
    const auto mode = address_mode(header.wrap);
    return {context.device,
            vk::SamplerCreateInfo{
                .magFilter = filter,
                .minFilter = filter,
                .mipmapMode = linear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest,
                .addressModeU = mode,
                .addressModeV = mode,
                .addressModeW = mode,
                .compareEnable = header.texel == SampledTexel::depth ? VK_TRUE : VK_FALSE,
                .compareOp = compare_op(header.compare),
                .maxLod = VK_LOD_CLAMP_NONE,
                .borderColor = is_float(header.texel) ? vk::BorderColor::eFloatTransparentBlack
                                                      : vk::BorderColor::eIntTransparentBlack}};
}

vk::ImageCreateInfo info_of(const SampledHeader& header) {
    return {
        .flags = is_cube(header.shape) ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags{},
        .imageType = image_type(header.shape),
        .format = format_of(header.texel),
        .extent = {header.width, header.height, is_3d(header) ? header.depth : 1},
        .mipLevels = header.levels,
        .arrayLayers = layers_of(header),
        .samples = vk::SampleCountFlagBits::e1,
        .tiling = vk::ImageTiling::eOptimal,
        .usage = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst,
        .initialLayout = vk::ImageLayout::eUndefined};
}

SampledHandles create(Context& context, const SampledHeader& header) {
    context.require_idle();
    if (header.shape == SampledShape::cube_layers &&
        context.physical.handle.getFeatures().imageCubeArray == VK_FALSE)
        throw backend::Unsupported("this device has no samplers of arrays of cubes");
    return {make_image(context, info_of(header), view_type(header.shape), aspect_of(header.texel),
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

SampledImage::Impl::Impl(Context& owner, std::span<const backend::Word> words)
    : context(owner), handles(owner, create(owner, backend::sampled_header(words))) {
    const SampledHeader header = backend::sampled_header(words);
    const std::vector<backend::Word> texels = backend::stored_texels(words);
    Buffer::Impl staging(context, std::as_bytes(std::span(texels)).size());
    std::memcpy(staging.mapped.data(), texels.data(), staging.mapped.size());
    context.run_once([&](const vk::raii::CommandBuffer& commands) {
        begin_general_layout(commands, *handles->image,
                             {.aspectMask = aspect_of(header.texel),
                              .levelCount = header.levels,
                              .layerCount = layers_of(header)});
        commands.copyBufferToImage(*staging.handles->buffer, *handles->image, vk::ImageLayout::eGeneral,
                                   copies_of(header));
    });
}

SampledImage::SampledImage(const Device& device, std::span<const backend::Word> words)
    : impl_(base::make_hidden<Impl>(device.impl(), words)) {}

}  // namespace gloam::gpu
