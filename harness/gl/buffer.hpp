// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gl/device.hpp"

namespace gloam::gl {

using Word = std::uint32_t;

// Memory of the device, in words of 32 bits; at least one.
class Buffer {
  public:
    // All zero. Throws OutOfMemory.
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

}  // namespace gloam::gl
