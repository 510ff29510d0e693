// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <string>
#include <vector>

#include "base/text.hpp"

namespace gloam::site {

// Little-endian bytes of values one after another, which the pages read.
class Bytes {
  public:
    template <class T>
    void add(T value) {
        static_assert(std::endian::native == std::endian::little);
        const auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    // As base64.
    [[nodiscard]] std::string text() const { return base::base64(bytes_); }

  private:
    std::vector<unsigned char> bytes_;
};

}  // namespace gloam::site
