// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace gloam::gpu {

// FNV-1a, 64 bits. Each step is a bijection of the state, so a change of a single byte always changes the
// hash.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::byte byte : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

}  // namespace gloam::gpu
