// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Rows from the top, channels of a pixel next to each other.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    std::vector<float> values;
};

// Portable float maps. Both throw std::runtime_error that names the file.
Picture read_pfm(const std::filesystem::path& file);
void write_pfm(const std::filesystem::path& file, const Picture& picture);

// What the passes are told of a frame: the values of push constants by their names, as 32-bit words.
using View = std::map<std::string, std::vector<std::uint32_t>>;

// Of fNNNN.json as gloam writes it. "previous_from_current" is there unless the camera has cut.
View read_view(const std::filesystem::path& file);

// The words of a SPIR-V module.
std::vector<std::uint32_t> read_words(const std::filesystem::path& file);
