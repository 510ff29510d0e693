// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "backend/sampled.hpp"
#include "backend/vulkan/device.hpp"
#include "base/hidden.hpp"

namespace gloam::backend::vulkan {

// A storage buffer in host-visible, coherent memory, mapped during its lifetime. Its contents are undefined
// at first. Throws std::runtime_error when `bytes` is 0 or exceeds the device's limit, or memory is
// exhausted.
class Buffer {
  public:
    Buffer(const Device& device, std::size_t bytes);

    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] std::span<std::byte> bytes();
    [[nodiscard]] std::span<const std::byte> bytes() const;

    // The mapped memory as elements of the trivially copyable T, without a remainder smaller than T.
    template <class T>
    [[nodiscard]] std::span<T> as() {
        return {reinterpret_cast<T*>(bytes().data()), size() / sizeof(T)};
    }
    template <class T>
    [[nodiscard]] std::span<const T> as() const {
        return {reinterpret_cast<const T*>(bytes().data()), size() / sizeof(T)};
    }

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

// Formats of storage images. Those of one and two channels, but for r32f and r32ui, need
// shaderStorageImageExtendedFormats, which most devices have.
enum class Format {
    r32f,
    rgba32f,
    rgba16f,
    rgba16ui,
    r16f,
    r8,
    r32ui,
    rg32f,
    rg16f,
    rgba8,
    r16ui,
    rg16ui,
    rg32ui,
    rgba32ui,
    rgb10_a2,
    r32i,
    rg32i,
    rgba32i
};

// The format that GLSL calls so: "rgba8".
[[nodiscard]] std::optional<Format> format_from(std::string_view name);

// The channels of a texel, each a float in uploads and downloads.
[[nodiscard]] int channels(Format format);

// Bytes of a texel in the image.
[[nodiscard]] std::uint64_t texel_bytes(Format format);

// A 2-D storage image in device memory, row 0 at the top. Its contents are undefined at first. Throws
// std::runtime_error when a side is 0 or exceeds the device's limit, the device does not support the format,
// or memory is exhausted. levels: how many it has, each of half the sides of the one before; uploads and
// downloads are of the first. layers: if not 0, it is an image2DArray of so many; throws backend::Unsupported
// where the device has no such storage image.
class Image {
  public:
    Image(const Device& device, Extent extent, Format format, std::uint32_t levels = 1,
          std::uint32_t layers = 0);

    [[nodiscard]] Extent extent() const;
    [[nodiscard]] Format format() const;
    [[nodiscard]] std::uint32_t levels() const;

    // Replaces or reads all texels: width * height * channels floats, row by row. Waits for the device.
    // Floats of 16 bits are converted from and to float32 (round to nearest even); r8, rgba8 and rgb10_a2
    // hold the nearest of 0 to 1 in their steps. A float of an image of integers has the bits of the integer,
    // of which one of 16 bits holds at most 65535. Throws std::invalid_argument for another count,
    // std::runtime_error like Commands::submit().
    void upload(std::span<const float> texels);
    [[nodiscard]] std::vector<float> download() const;

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

// A level of an image, for a binding that writes it.
struct ImageLevel {
    std::reference_wrapper<const Image> image;
    std::uint32_t level = 0;
};

// An image that a binding samples bilinearly.
struct LinearImage {
    std::reference_wrapper<const Image> image;
};

// An image in device memory with its sampler. The words are those of backend/sampled.hpp. Throws
// std::invalid_argument where they disagree; std::runtime_error when memory is exhausted.
class SampledImage {
  public:
    SampledImage(const Device& device, std::span<const backend::Word> words);

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

}  // namespace gloam::backend::vulkan
