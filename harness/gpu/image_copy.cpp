// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "gpu/image.hpp"
#include "gpu/internal/buffer_impl.hpp"
#include "gpu/internal/half.hpp"
#include "gpu/internal/image_impl.hpp"

namespace gloam::gpu {
namespace {

// Copies bands of whole rows: an image may exceed the largest buffer, and staging all of it would double its
// memory.
constexpr std::size_t band_bytes = std::size_t{32} << 20;

struct Band {
    std::uint32_t first_row;
    std::uint32_t rows;
};

std::size_t row_floats(const Image::Impl& image) {
    return std::size_t{image.extent.width} * static_cast<std::size_t>(traits(image.format).channels);
}

std::size_t row_bytes(const Image::Impl& image) {
    return image.extent.width * traits(image.format).texel_bytes;
}

std::uint32_t band_rows(const Image::Impl& image) {
    const auto rows = std::clamp<std::size_t>(band_bytes / row_bytes(image), 1, image.extent.height);
    return static_cast<std::uint32_t>(rows);
}

vk::BufferImageCopy copy_region(const Image::Impl& image, Band band) {
    return {.imageSubresource = {.aspectMask = traits(image.format).aspect, .layerCount = 1},
            .imageOffset = {0, static_cast<std::int32_t>(band.first_row), 0},
            .imageExtent = {image.extent.width, band.rows, 1}};
}

// The nearest integer of 16 bits; 0 for NaN.
std::uint16_t to_uint16(float value) {
    return value > 0.0F ? static_cast<std::uint16_t>(std::lround(std::min(value, 65535.0F)))
                        : std::uint16_t{0};
}

// The nearest of 0 to 1 in steps of 1/255; 0 for NaN.
std::uint8_t to_unorm8(float value) {
    return value > 0.0F ? static_cast<std::uint8_t>(std::lround(std::min(value, 1.0F) * 255.0F))
                        : std::uint8_t{0};
}

void encode(Format format, std::span<const float> texels, std::byte* staging) {
    auto* shorts = reinterpret_cast<std::uint16_t*>(staging);
    if (format == Format::r8) {
        std::ranges::transform(texels, reinterpret_cast<std::uint8_t*>(staging), to_unorm8);
    } else if (format == Format::rgba16f || format == Format::r16f) {
        std::ranges::transform(texels, shorts, to_half);
    } else if (format == Format::rgba16ui) {
        std::ranges::transform(texels, shorts, to_uint16);
    } else {
        std::memcpy(staging, texels.data(), texels.size_bytes());
    }
}

void decode(Format format, const std::byte* staging, std::span<float> texels) {
    const auto* shorts = reinterpret_cast<const std::uint16_t*>(staging);
    if (format == Format::r8) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(staging);
        std::transform(bytes, bytes + texels.size(), texels.begin(),
                       [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; });
    } else if (format == Format::rgba16f || format == Format::r16f) {
        std::transform(shorts, shorts + texels.size(), texels.begin(), from_half);
    } else if (format == Format::rgba16ui) {
        std::copy(shorts, shorts + texels.size(), texels.begin());
    } else {
        std::memcpy(texels.data(), staging, texels.size_bytes());
    }
}

// Calls move(staging, band, floats before the band, floats in it) for each band of the image.
template <class Move>
void for_each_band(const Image::Impl& image, Move move) {
    const auto most = band_rows(image);
    Buffer::Impl staging(image.context, most * row_bytes(image));
    for (std::uint32_t row = 0; row < image.extent.height; row += most) {
        const Band band{row, std::min(most, image.extent.height - row)};
        move(staging, band, row * row_floats(image), band.rows * row_floats(image));
    }
}

}  // namespace

void Image::upload(std::span<const float> texels) {
    const auto& image = *impl_;
    const auto expected = row_floats(image) * image.extent.height;
    if (texels.size() != expected) {
        throw std::invalid_argument(fmt::format("upload of {} floats to an image of {}x{} {}: expected {}",
                                                texels.size(), image.extent.width, image.extent.height,
                                                traits(image.format).name, expected));
    }
    for_each_band(image, [&](Buffer::Impl& staging, Band band, std::size_t first, std::size_t count) {
        encode(image.format, texels.subspan(first, count), staging.mapped.data());
        image.context.run_once([&](const vk::raii::CommandBuffer& commands) {
            commands.copyBufferToImage(*staging.handles->buffer, *image.handles->image,
                                       vk::ImageLayout::eGeneral, copy_region(image, band));
        });
    });
}

std::vector<float> Image::download() const {
    const auto& image = *impl_;
    std::vector<float> texels(row_floats(image) * image.extent.height);
    for_each_band(image, [&](Buffer::Impl& staging, Band band, std::size_t first, std::size_t count) {
        image.context.run_once([&](const vk::raii::CommandBuffer& commands) {
            commands.copyImageToBuffer(*image.handles->image, vk::ImageLayout::eGeneral,
                                       *staging.handles->buffer, copy_region(image, band));
        });
        decode(image.format, staging.mapped.data(), std::span(texels).subspan(first, count));
    });
    return texels;
}

}  // namespace gloam::gpu
