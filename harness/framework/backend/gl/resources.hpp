// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backend/gl/device.hpp"

namespace gloam::gl {

using backend::Word;

// Memory of the device, in words of 32 bits; at least one.
class Buffer {
  public:
    // All zero. Throws backend::OutOfMemory.
    Buffer(const Device& device, std::size_t words);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&&) = delete;

    // `first + words.size()` is at most size().
    void write(std::size_t first, std::span<const Word> words);
    [[nodiscard]] std::vector<Word> read() const;

    [[nodiscard]] std::size_t size() const { return words_; }
    [[nodiscard]] std::uint32_t handle() const { return handle_; }

  private:
    const Device* device_;
    std::size_t words_ = 0;
    std::uint32_t handle_ = 0;
};

// An image of floats that compute shaders load from and store to.
class Image {
  public:
    enum class Format { r32f, rgba16f, rgba32f };

    // All zero. Throws backend::OutOfMemory; CallFailed on a device without compute shaders.
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

// A texture with a sampler's state. The words are those of backend/sampled.hpp. Needs compute shaders.
class SampledTexture {
  public:
    // Throws backend::OutOfMemory; backend::Unsupported for one dimension; std::invalid_argument for words
    // that disagree.
    SampledTexture(const Device& device, std::span<const Word> words);
    ~SampledTexture();
    SampledTexture(SampledTexture&& other) noexcept;
    SampledTexture& operator=(SampledTexture&&) = delete;

    void bind(std::uint32_t unit) const;

  private:
    const Device* device_;
    std::uint32_t target_ = 0;
    std::uint32_t handle_ = 0;
};

// Words that a fragment shader reads: an unsigned texture of one channel (R32UI). Word i is the texel
// (i % row, i / row).
class WordTexture {
  public:
    static constexpr std::size_t row = 2048;  // the side that every version has at least

    // The most words that one can hold on a device.
    [[nodiscard]] static std::size_t most_words(const DeviceInfo& info) { return row * info.max_image_size; }

    // Throws backend::OutOfMemory; std::invalid_argument beyond most_words().
    WordTexture(const Device& device, std::span<const Word> words);
    ~WordTexture();
    WordTexture(WordTexture&& other) noexcept;
    WordTexture& operator=(WordTexture&&) = delete;

    [[nodiscard]] std::uint32_t handle() const { return handle_; }

  private:
    const Device* device_;
    std::uint32_t handle_ = 0;
};

}  // namespace gloam::gl
