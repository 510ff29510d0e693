// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gl/buffer.hpp"

namespace gloam::gl {

// Words that a fragment shader reads: an unsigned texture of one channel (R32UI). Word i is the texel
// (i % row, i / row).
class WordTexture {
  public:
    static constexpr std::size_t row = 2048;  // the side that every version has at least

    // The most words that one can hold on a device.
    [[nodiscard]] static std::size_t most_words(const DeviceInfo& info) {
        return row * info.max_texture_size;
    }

    // Throws OutOfMemory; std::invalid_argument beyond most_words().
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
