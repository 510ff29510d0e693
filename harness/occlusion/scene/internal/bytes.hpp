// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::scene {

// Lists of numbers as bytes, for files of this program alone and for its other processes.
template <class... T>
std::string bytes_of(const std::vector<T>&... lists) {
    std::string bytes;
    const auto add = [&](const auto& list) {
        const std::uint64_t count = list.size();
        bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
        bytes.append(reinterpret_cast<const char*>(list.data()), count * sizeof list[0]);
    };
    (add(lists), ...);
    return bytes;
}

// The same lists again. Throws std::runtime_error for bytes of others.
template <class... T>
void read_bytes(std::string_view bytes, std::vector<T>&... lists) {
    const auto take = [&](void* to, std::size_t size) {
        if (size > bytes.size()) throw std::runtime_error("lists that are cut short");
        if (size > 0) std::memcpy(to, bytes.data(), size);
        bytes.remove_prefix(size);
    };
    const auto read = [&](auto& list) {
        std::uint64_t count = 0;
        take(&count, sizeof count);
        if (count > bytes.size()) throw std::runtime_error("lists that are cut short");
        list.resize(count);
        take(list.data(), count * sizeof list[0]);
    };
    (read(lists), ...);
}

}  // namespace gloam::scene
