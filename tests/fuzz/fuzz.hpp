// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gloam::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

// A file in memory that holds these bytes, until the next one.
inline const std::filesystem::path& file_of(std::string_view bytes, const char* extension) {
    static const std::filesystem::path path =
        std::filesystem::path("/dev/shm") / ("gloam-fuzz-" + std::to_string(getpid()) + extension);
    if (!(std::ofstream(path, std::ios::binary) << bytes)) std::abort();
    return path;
}

inline void require(bool promise) {
    if (!promise) std::abort();
}

// A reader returns a result, or throws an exception of the standard library with a short message.
template <class Read>
void read_or_refuse(const Read& read) {
    constexpr std::size_t longest = 2000;
    try {
        read();
    } catch (const std::runtime_error& error) {
        require(std::string_view(error.what()).size() < longest);
    } catch (const std::invalid_argument& error) {
        require(std::string_view(error.what()).size() < longest);
    }
}

}  // namespace gloam::fuzz
