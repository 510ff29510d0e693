// SPDX-License-Identifier: MIT
#pragma once

#include "base/files.hpp"
#include "support/test.hpp"

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

// Tests with a folder of their own.
class InFolder : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder.path() / name; }

    // Where the file with that text is.
    std::filesystem::path write(const std::string& name, std::string_view text) const {
        return folder.write(name, text);
    }

    const TemporaryDirectory folder;
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
