// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "gpu/device.hpp"

namespace gloam::gpu {

// A storage buffer in host-visible, coherent memory, mapped during its lifetime. Its contents are undefined
// at first. Throws std::runtime_error when `bytes` is 0 or exceeds the device's limit, or memory is
// exhausted.
class Buffer {
  public:
    Buffer(const Device& device, std::size_t bytes);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;

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

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
