// SPDX-License-Identifier: MIT
#include "base/base64.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gloam::base {

std::string base64(std::span<const unsigned char> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    std::uint32_t bits = 0;
    int held = 0;
    for (const unsigned char byte : bytes) {
        bits = bits << 8U | byte;
        for (held += 8; held >= 6; held -= 6) text += digits[bits >> (held - 6) & 63U];
    }
    if (held > 0) text += digits[bits << (6 - held) & 63U];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

}  // namespace gloam::base
