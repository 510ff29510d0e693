// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gpu/device.hpp"

namespace gloam::gpu {

// Formats that every Vulkan device can store to and render to, plus the depth attachment.
enum class Format { r32f, rgba32f, rgba16f, rgba16ui, depth32f };

// Floats per texel as uploaded and downloaded.
[[nodiscard]] int channels(Format format);

struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
};

// A 2-D image in device memory, row 0 at the top: storage image and colour attachment, or (depth32f) depth
// attachment only. Contents start undefined. Throws std::runtime_error when a side is 0 or larger than the
// device allows, the device has no such images, or memory is short.
class Image {
  public:
    Image(const Device& device, Extent extent, Format format);
    ~Image();
    Image(Image&&) noexcept;
    Image& operator=(Image&&) noexcept;

    [[nodiscard]] Extent extent() const;
    [[nodiscard]] Format format() const;

    // Replaces or reads all texels: width * height * channels floats, row by row. Waits for the device.
    // rgba16f is converted from and to float32 (round to nearest even), and rgba16ui (to the nearest of 0 to
    // 65535). Throws std::invalid_argument on
    // another count, std::runtime_error like Commands::submit().
    void upload(std::span<const float> texels);
    [[nodiscard]] std::vector<float> download() const;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
