// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gl/device.hpp"

namespace gloam::gl {

// An image of floats that compute shaders load from and store to.
class Image {
  public:
    enum class Format { r32f, rgba16f, rgba32f };

    // All zero. Throws OutOfMemory; CallFailed on a device without compute shaders.
    Image(const Device& device, Format format, std::size_t width, std::size_t height);
    ~Image();
    Image(Image&& other) noexcept;
    Image& operator=(Image&&) = delete;

    // All texels, row by row, one number for each channel. Throws std::invalid_argument for another count.
    void write(std::span<const float> channels);
    // The same, but always four channels; those that the format lacks are 0, 0, 1.
    [[nodiscard]] std::vector<float> read() const;

    [[nodiscard]] Format format() const { return format_; }
    [[nodiscard]] std::uint32_t handle() const { return handle_; }

  private:
    const Device* device_;
    Format format_;
    std::size_t width_;
    std::size_t height_;
    std::uint32_t handle_ = 0;
};

// The number of channels: 1 or 4.
[[nodiscard]] std::size_t channels_of(Image::Format format);

}  // namespace gloam::gl
