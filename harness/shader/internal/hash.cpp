// SPDX-License-Identifier: MIT
#include "shader/internal/hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gloam::shader::internal {

void Fingerprint::add(std::string_view field) {
    add(static_cast<std::uint64_t>(field.size()));
    bytes_ += field;
}

void Fingerprint::add(std::uint64_t field) {
    for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>((field >> shift) & 0xffu);
}

Hash Fingerprint::hash() const {
    return hash_of(bytes_);
}

Hash hash_of(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return {hash.high64, hash.low64};
}

std::string to_hex(const Hash& hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint64_t word : hash)
        for (int shift = 60; shift >= 0; shift -= 4) text += digits[(word >> shift) & 0xfu];
    return text;
}

}  // namespace gloam::shader::internal
