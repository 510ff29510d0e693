// SPDX-License-Identifier: MIT
#include "backend/vulkan/resources.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"
#include "base/half.hpp"

namespace gloam::backend::vulkan {

Buffer::Handles make_buffer(Context& context, std::size_t bytes) {
    const auto limit = context.physical.info.max_buffer_bytes;
    if (bytes == 0 || bytes > limit) {
        throw std::runtime_error(fmt::format("buffer of {} bytes: device \"{}\" allows 1 to {}", bytes,
                                             context.physical.info.name, limit));
    }
    using Usage = vk::BufferUsageFlagBits;
    vk::raii::Buffer buffer(
        context.device,
        vk::BufferCreateInfo{.size = bytes,
                             .usage = Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eIndirectBuffer |
                                      Usage::eTransferSrc | Usage::eTransferDst});
    // Cached memory: the host reads results back, which is very slow from write-combined memory.
    using Property = vk::MemoryPropertyFlagBits;
    constexpr auto coherent = Property::eHostVisible | Property::eHostCoherent;
    auto memory =
        allocate(context, buffer.getMemoryRequirements(), {coherent | Property::eHostCached, coherent},
                 fmt::format("buffer of {} bytes", bytes));
    buffer.bindMemory(*memory, 0);
    auto* mapped = static_cast<std::byte*>(memory.mapMemory(0, VK_WHOLE_SIZE));
    return {context, std::move(buffer), std::move(memory), {mapped, bytes}};
}

Buffer::Buffer(const Device& device, std::size_t bytes) : handles(owned(make_buffer(device.impl(), bytes))) {}

std::size_t Buffer::size() const {
    return handles->mapped.size();
}
std::span<std::byte> Buffer::bytes() {
    return handles->mapped;
}
std::span<const std::byte> Buffer::bytes() const {
    return handles->mapped;
}

namespace {

// How an image keeps a channel: 32 bits as they are; float16; integers of 16 bits; steps of 1/255; of three
// channels steps of 1/1023, of the fourth of 1/3.
enum class TexelKind { words, halves, shorts, unorm8, unorm10 };

// Properties of a Format for Vulkan and for copies.
struct FormatTraits {
    std::string_view name;
    vk::Format format;
    int channels;
    std::size_t texel_bytes;
    TexelKind kind;
};

// In the order of Format.
constexpr std::array all_traits{
    FormatTraits{"r32f", vk::Format::eR32Sfloat, 1, 4, TexelKind::words},
    FormatTraits{"rgba32f", vk::Format::eR32G32B32A32Sfloat, 4, 16, TexelKind::words},
    FormatTraits{"rgba16f", vk::Format::eR16G16B16A16Sfloat, 4, 8, TexelKind::halves},
    FormatTraits{"rgba16ui", vk::Format::eR16G16B16A16Uint, 4, 8, TexelKind::shorts},
    FormatTraits{"r16f", vk::Format::eR16Sfloat, 1, 2, TexelKind::halves},
    FormatTraits{"r8", vk::Format::eR8Unorm, 1, 1, TexelKind::unorm8},
    FormatTraits{"r32ui", vk::Format::eR32Uint, 1, 4, TexelKind::words},
    FormatTraits{"rg32f", vk::Format::eR32G32Sfloat, 2, 8, TexelKind::words},
    FormatTraits{"rg16f", vk::Format::eR16G16Sfloat, 2, 4, TexelKind::halves},
    FormatTraits{"rgba8", vk::Format::eR8G8B8A8Unorm, 4, 4, TexelKind::unorm8},
    FormatTraits{"r16ui", vk::Format::eR16Uint, 1, 2, TexelKind::shorts},
    FormatTraits{"rg16ui", vk::Format::eR16G16Uint, 2, 4, TexelKind::shorts},
    FormatTraits{"rg32ui", vk::Format::eR32G32Uint, 2, 8, TexelKind::words},
    FormatTraits{"rgba32ui", vk::Format::eR32G32B32A32Uint, 4, 16, TexelKind::words},
    FormatTraits{"rgb10_a2", vk::Format::eA2B10G10R10UnormPack32, 4, 4, TexelKind::unorm10},
    FormatTraits{"r32i", vk::Format::eR32Sint, 1, 4, TexelKind::words},
    FormatTraits{"rg32i", vk::Format::eR32G32Sint, 2, 8, TexelKind::words},
    FormatTraits{"rgba32i", vk::Format::eR32G32B32A32Sint, 4, 16, TexelKind::words}};

const FormatTraits& traits(Format format) {
    return all_traits.at(static_cast<std::size_t>(format));
}

std::string describe(Extent extent, Format format) {
    return fmt::format("image of {}x{} {}", extent.width, extent.height, traits(format).name);
}

vk::ImageCreateInfo create_info(Extent extent, Format format, std::uint32_t levels, std::uint32_t layers) {
    using Usage = vk::ImageUsageFlagBits;
    return {.imageType = vk::ImageType::e2D,
            .format = traits(format).format,
            .extent = {extent.width, extent.height, 1},
            .mipLevels = levels,
            .arrayLayers = std::max(layers, 1U),
            .samples = vk::SampleCountFlagBits::e1,
            .tiling = vk::ImageTiling::eOptimal,
            .usage = Usage::eStorage | Usage::eSampled | Usage::eTransferSrc | Usage::eTransferDst,
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
    const auto most = limits(context, create_info(extent, format, 1, 0), format).maxResourceSize;
    if (bytes > most) {
        throw std::runtime_error(fmt::format("{}: {} bytes, device \"{}\" allows {}",
                                             describe(extent, format), bytes, device.name, most));
    }
}

std::vector<vk::raii::ImageView> views_of_levels(const Context& context, vk::Image image, Format format,
                                                 std::uint32_t levels) {
    std::vector<vk::raii::ImageView> views;
    for (std::uint32_t level = 0; level < levels; ++level)
        views.emplace_back(
            context.device,
            vk::ImageViewCreateInfo{.image = image,
                                    .viewType = vk::ImageViewType::e2D,
                                    .format = traits(format).format,
                                    .subresourceRange = {vk::ImageAspectFlagBits::eColor, level, 1, 0, 1}});
    return views;
}

Image::Handles create(Context& context, Extent extent, Format format, std::uint32_t levels,
                      std::uint32_t layers) {
    context.require_idle();  // a driver may wait for the work before it makes an image
    const auto features = context.physical.handle.getFormatProperties(traits(format).format);
    if (layers > 0 && !(features.optimalTilingFeatures & vk::FormatFeatureFlagBits::eStorageImage))
        throw backend::Unsupported(
            fmt::format("this device stores to no image of the format {}", traits(format).name));
    check_size(context, extent, format);
    ImageHandles all = make_image(context, create_info(extent, format, levels, layers),
                                  layers > 0 ? vk::ImageViewType::e2DArray : vk::ImageViewType::e2D,
                                  vk::ImageAspectFlagBits::eColor, describe(extent, format));
    auto views = views_of_levels(context, *all.image, format, levels);
    return {std::move(all), extent, format, std::move(views)};
}

// Copies bands of whole rows: an image may exceed the largest buffer, and staging all of it would double its
// memory.
constexpr std::size_t band_bytes = std::size_t{32} << 20;

struct Band {
    std::uint32_t first_row;
    std::uint32_t rows;
};

std::size_t row_floats(const Image::Handles& image) {
    return std::size_t{image.extent.width} * static_cast<std::size_t>(traits(image.format).channels);
}

std::size_t row_bytes(const Image::Handles& image) {
    return image.extent.width * traits(image.format).texel_bytes;
}

std::uint32_t band_rows(const Image::Handles& image) {
    const auto rows = std::clamp<std::size_t>(band_bytes / row_bytes(image), 1, image.extent.height);
    return static_cast<std::uint32_t>(rows);
}

vk::BufferImageCopy copy_region(const Image::Handles& image, Band band) {
    return {.imageSubresource = {.aspectMask = vk::ImageAspectFlagBits::eColor, .layerCount = 1},
            .imageOffset = {0, static_cast<std::int32_t>(band.first_row), 0},
            .imageExtent = {image.extent.width, band.rows, 1}};
}

// The nearest of 0 to 1 in so many steps; 0 for NaN.
std::uint32_t to_unorm(float value, float steps) {
    return value > 0.0F ? static_cast<std::uint32_t>(std::lround(std::min(value, 1.0F) * steps)) : 0U;
}

// The steps of a channel of rgb10_a2, whose channels stand beside each other in a word.
float steps_of(std::size_t channel) {
    return channel < 3 ? 1023.0F : 3.0F;
}

void encode(TexelKind kind, std::span<const float> texels, std::byte* staging) {
    auto* shorts = reinterpret_cast<std::uint16_t*>(staging);
    auto* words = reinterpret_cast<std::uint32_t*>(staging);
    if (kind == TexelKind::unorm8) {
        std::ranges::transform(texels, reinterpret_cast<std::uint8_t*>(staging), [](float value) {
            return static_cast<std::uint8_t>(to_unorm(value, 255.0F));
        });
    } else if (kind == TexelKind::unorm10) {
        for (std::size_t i = 0; i < texels.size(); ++i) {
            if (i % 4 == 0) words[i / 4] = 0;
            words[i / 4] |= to_unorm(texels[i], steps_of(i % 4)) << 10 * (i % 4);
        }
    } else if (kind == TexelKind::halves) {
        std::ranges::transform(texels, shorts, base::to_half);
    } else if (kind == TexelKind::shorts) {
        std::ranges::transform(texels, shorts, [](float bits) {
            return static_cast<std::uint16_t>(std::min(std::bit_cast<std::uint32_t>(bits), 0xFFFFU));
        });
    } else {
        std::memcpy(staging, texels.data(), texels.size_bytes());
    }
}

void decode(TexelKind kind, const std::byte* staging, std::span<float> texels) {
    const auto* shorts = reinterpret_cast<const std::uint16_t*>(staging);
    const auto* words = reinterpret_cast<const std::uint32_t*>(staging);
    if (kind == TexelKind::unorm8) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(staging);
        std::transform(bytes, bytes + texels.size(), texels.begin(),
                       [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; });
    } else if (kind == TexelKind::unorm10) {
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const float steps = steps_of(i % 4);
            const std::uint32_t stored = words[i / 4] >> 10 * (i % 4) & static_cast<std::uint32_t>(steps);
            texels[i] = static_cast<float>(stored) * (1.0F / steps);
        }
    } else if (kind == TexelKind::halves) {
        std::transform(shorts, shorts + texels.size(), texels.begin(), base::from_half);
    } else if (kind == TexelKind::shorts) {
        std::transform(shorts, shorts + texels.size(), texels.begin(),
                       [](std::uint16_t value) { return std::bit_cast<float>(std::uint32_t{value}); });
    } else {
        std::memcpy(texels.data(), staging, texels.size_bytes());
    }
}

// Calls move(staging, band, floats before the band, floats in it) for each band of the image.
template <class Move>
void for_each_band(const Image::Handles& image, Move move) {
    const auto most = band_rows(image);
    const auto staging = owned(make_buffer(image.context, most * row_bytes(image)));
    for (std::uint32_t row = 0; row < image.extent.height; row += most) {
        const Band band{row, std::min(most, image.extent.height - row)};
        move(*staging, band, row * row_floats(image), band.rows * row_floats(image));
    }
}

}  // namespace

std::optional<Format> format_from(std::string_view name) {
    const auto found = std::ranges::find(all_traits, name, &FormatTraits::name);
    return found == all_traits.end() ? std::nullopt : std::optional(Format(found - all_traits.begin()));
}

int channels(Format format) {
    return traits(format).channels;
}

std::uint64_t texel_bytes(Format format) {
    return traits(format).texel_bytes;
}

ImageHandles make_image(Context& context, const vk::ImageCreateInfo& info, vk::ImageViewType type,
                        vk::ImageAspectFlags aspect, const std::string& purpose) {
    vk::raii::Image image(context.device, info);
    auto memory = allocate(context, image.getMemoryRequirements(),
                           {vk::MemoryPropertyFlagBits::eDeviceLocal, {}}, purpose);
    image.bindMemory(*memory, 0);
    vk::raii::ImageView view(context.device,
                             vk::ImageViewCreateInfo{.image = *image,
                                                     .viewType = type,
                                                     .format = info.format,
                                                     .subresourceRange = {.aspectMask = aspect,
                                                                          .levelCount = info.mipLevels,
                                                                          .layerCount = info.arrayLayers}});
    return {context, std::move(image), std::move(memory), std::move(view)};
}

void begin_general_layout(const vk::raii::CommandBuffer& commands, const ImageHandles& image,
                          const vk::ImageSubresourceRange& all_of_it) {
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    using Access = vk::AccessFlagBits;
    const vk::ImageMemoryBarrier barrier{.dstAccessMask = Access::eMemoryRead | Access::eMemoryWrite,
                                         .oldLayout = vk::ImageLayout::eUndefined,
                                         .newLayout = vk::ImageLayout::eGeneral,
                                         .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .image = *image.image,
                                         .subresourceRange = all_of_it};
    commands.pipelineBarrier(all, all, {}, nullptr, nullptr, barrier);
}

Image::Image(const Device& device, Extent extent, Format format, std::uint32_t levels, std::uint32_t layers)
    : handles(owned(create(device.impl(), extent, format, levels, layers))) {
    handles->context.run_once([&](const vk::raii::CommandBuffer& commands) {
        begin_general_layout(commands, *handles,
                             {.aspectMask = vk::ImageAspectFlagBits::eColor,
                              .levelCount = levels,
                              .layerCount = std::max(layers, 1U)});
    });
}

Extent Image::extent() const {
    return handles->extent;
}
Format Image::format() const {
    return handles->format;
}
std::uint32_t Image::levels() const {
    return static_cast<std::uint32_t>(handles->levels.size());
}

void Image::upload(std::span<const float> texels) {
    const auto& image = *handles;
    const auto expected = row_floats(image) * image.extent.height;
    if (texels.size() != expected) {
        throw std::invalid_argument(fmt::format("upload of {} floats to an image of {}x{} {}: expected {}",
                                                texels.size(), image.extent.width, image.extent.height,
                                                traits(image.format).name, expected));
    }
    for_each_band(image, [&](Buffer::Handles& staging, Band band, std::size_t first, std::size_t count) {
        encode(traits(image.format).kind, texels.subspan(first, count), staging.mapped.data());
        image.context.run_once([&](const vk::raii::CommandBuffer& commands) {
            commands.copyBufferToImage(*staging.buffer, *image.image, vk::ImageLayout::eGeneral,
                                       copy_region(image, band));
        });
    });
}

std::vector<float> Image::download() const {
    const auto& image = *handles;
    std::vector<float> texels(row_floats(image) * image.extent.height);
    for_each_band(image, [&](Buffer::Handles& staging, Band band, std::size_t first, std::size_t count) {
        image.context.run_once([&](const vk::raii::CommandBuffer& commands) {
            commands.copyImageToBuffer(*image.image, vk::ImageLayout::eGeneral, *staging.buffer,
                                       copy_region(image, band));
        });
        decode(traits(image.format).kind, staging.mapped.data(), std::span(texels).subspan(first, count));
    });
    return texels;
}

}  // namespace gloam::backend::vulkan
