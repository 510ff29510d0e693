// SPDX-License-Identifier: MIT
#pragma once
// What an engine has already: here the files of docs/gbuffer-format.md.

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

inline std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw std::runtime_error(file.string() + ": cannot read the file");
    return bytes;
}

// The numbers of "key": [...]; empty where there are none.
inline std::vector<float> numbers_of(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\"");
    const std::size_t begin = json.find_first_not_of(" \n:", at + key.size() + 2);
    std::vector<float> numbers;
    if (at == std::string::npos || json[begin] != '[') return numbers;
    std::istringstream stream(json.substr(begin + 1));
    for (double number = 0; stream >> number; stream.ignore()) numbers.push_back(static_cast<float>(number));
    return numbers;
}

// Rows from the top, the channels of a pixel beside each other.
struct Picture {
    int width = 0, height = 0, channels = 1;
    std::vector<float> values;
};

// A portable float map, whose rows are from the bottom up. All of its channels, or more, which are 0.
inline Picture read_pfm(const std::filesystem::path& file, int channels) {
    const std::string bytes = read_file(file);
    std::istringstream head(bytes);
    std::string kind, scale;
    Picture picture{0, 0, channels, {}};
    head >> kind >> picture.width >> picture.height >> scale;
    const int stored = kind == "PF" ? 3 : 1;
    picture.values.resize(std::size_t(picture.width) * picture.height * channels);
    const char* texel = bytes.data() + head.tellg() + 1;
    for (int y = picture.height; y-- > 0;)
        for (int x = 0; x < picture.width; ++x, texel += 4 * stored)
            std::memcpy(&picture.values[(std::size_t(y) * picture.width + x) * channels], texel, 4 * stored);
    return picture;
}

inline void write_pfm(const std::filesystem::path& file, const Picture& picture) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << "Pf\n" << picture.width << " " << picture.height << "\n-1.0\n";
    for (int y = picture.height; y-- > 0;)
        stream.write(reinterpret_cast<const char*>(&picture.values[std::size_t(y) * picture.width]),
                     4 * picture.width);
    if (!stream.flush()) throw std::runtime_error(file.string() + ": cannot write the file");
}

// "f0007"
inline std::string frame_name(int number) {
    const std::string digits = std::to_string(number);
    return "f" + std::string(4 - digits.size(), '0') + digits;
}
