// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"

namespace gloam::test {

// A folder of a test's own, with its files.
class TemporaryDirectory : public base::TemporaryFolder {
  public:
    TemporaryDirectory() : TemporaryFolder("test") {}

    // Writes a file, in folders that are made where they are missing, and returns where it is.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const {
        const std::filesystem::path file = path() / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream stream(file, std::ios::binary);
        stream << content;
        stream.close();
        if (!stream) throw std::runtime_error("cannot write " + file.string());
        return file;
    }
};

// All bytes of a file; "" where it cannot be read.
inline std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The bytes of a float, most significant first or last.
inline std::string bytes(const std::vector<float>& values, bool little_endian) {
    std::string text;
    for (const float value : values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int i = 0; i < 4; ++i)
            text += static_cast<char>(bits >> (little_endian ? 8 * i : 24 - 8 * i) & 0xFFU);
    }
    return text;
}

inline std::vector<std::uint32_t> bits(const std::vector<float>& values) {
    std::vector<std::uint32_t> result;
    for (const float value : values) result.push_back(std::bit_cast<std::uint32_t>(value));
    return result;
}

}  // namespace gloam::test
