// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backend/gl/device.hpp"

namespace gloam::backend::gl {

using backend::Word;

// An object of OpenGL, deleted with this.
class Handle {
  public:
    enum class Kind { buffer, texture, framebuffer, program };

    Handle(const Device& device, Kind kind);
    ~Handle();
    Handle(Handle&& other) noexcept
        : device_(other.device_), kind_(other.kind_), name_(std::exchange(other.name_, 0U)) {}
    Handle& operator=(Handle&&) = delete;

    [[nodiscard]] const Device& device() const { return *device_; }
    [[nodiscard]] std::uint32_t name() const { return name_; }

  private:
    const Device* device_;
    Kind kind_;
    std::uint32_t name_ = 0;
};

// Memory of the device, in words of 32 bits; at least one.
class Buffer {
  public:
    // These words; behind them zeros, where `size` is more. Throws backend::OutOfMemory.
    Buffer(const Device& device, std::span<const Word> words, std::size_t size = 1);

    [[nodiscard]] std::vector<Word> read() const;

    [[nodiscard]] std::uint32_t handle() const { return handle_.name(); }

  private:
    std::size_t words_;
    Handle handle_;
};

// An image that compute shaders load from, store to, and sample: the nearest texel, that at the edge beyond
// it.
class Image {
  public:
    // format: as GLSL calls it. texels: row by row, four words each, bits of the floats or integers that a
    // shader sees; those that the format lacks are not kept. Throws backend::Unsupported for a format that
    // the version of OpenGL lacks, backend::Error.
    Image(const Device& device, const std::string& format, std::size_t width, std::size_t height,
          std::span<const Word> texels);

    // The texels, likewise; what the format lacks is 0, 0, 1.
    [[nodiscard]] std::vector<Word> read() const;

    [[nodiscard]] std::uint32_t format() const { return format_; }  // OpenGL's name of it
    [[nodiscard]] std::uint32_t handle() const { return handle_.name(); }

  private:
    std::uint32_t format_ = 0;
    bool integers_ = false;
    std::size_t width_;
    std::size_t height_;
    Handle handle_;
};

// A texture with a sampler's state. The words are those of backend/sampled.hpp. Needs compute shaders.
class SampledTexture {
  public:
    // Throws backend::OutOfMemory; std::invalid_argument for words that disagree.
    SampledTexture(const Device& device, std::span<const Word> words);

    void bind(std::uint32_t unit) const;

  private:
    std::uint32_t target_;
    Handle handle_;
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

    [[nodiscard]] std::uint32_t handle() const { return handle_.name(); }

  private:
    Handle handle_;
};

}  // namespace gloam::backend::gl
