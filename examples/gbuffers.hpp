// SPDX-License-Identifier: MIT
#pragma once
// What an engine has already: here the files of docs/gbuffer-format.md.
#include <gloam_frame.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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
    const std::size_t pixels = std::size_t(picture.width) * picture.height;
    if (!head || picture.width < 1 || picture.height < 1 ||
        bytes.size() != std::size_t(head.tellg()) + 1 + 4 * stored * pixels)
        throw std::runtime_error(file.string() + ": expected a whole portable float map");
    picture.values.resize(pixels * channels);
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

// arguments: GBUFFERS OUT RADIUS linear|buffer: the folder of the files, that of the results, the radius of
// influence in world units, and whether the files hold eye-linear depth or that of a depth buffer. Says each
// frame of the sequence how it is seen, and writes the occlusion, in 1/255, that draw(frame, depth, normal)
// returns.
template <class Draw>
void each_frame(char** arguments, const Draw& draw) {
    const std::string gbuffers = std::string(arguments[0]) + "/", out = std::string(arguments[1]) + "/";
    const float radius = std::strtof(arguments[2], nullptr);
    const std::string kind = arguments[3];
    if (!(radius > 0.0F))
        throw std::runtime_error("RADIUS " + std::string(arguments[2]) + ": expected world units");
    if (kind != "linear" && kind != "buffer") throw std::runtime_error(kind + ": expected linear or buffer");
    if (!std::filesystem::exists(gbuffers + "f0000.json"))
        throw std::runtime_error(gbuffers +
                                 "f0000.json: no such file; gloam render --write-gbuffer writes it");
    gloam_frame frame{};
    for (int number = 0; std::filesystem::exists(gbuffers + frame_name(number) + ".json"); ++number) {
        const std::string name = frame_name(number), json = read_file(gbuffers + name + ".json");
        const Picture depth = read_pfm(gbuffers + name + "_depth.pfm", 1);
        const Picture normal = read_pfm(gbuffers + name + "_normal.pfm", 4);
        const std::vector<float> motion = numbers_of(json, "previous_from_current");
        // Another preset, radius or size begins a sequence, and so does NULL; gloam_cut() asks for it.
        const gloam_settings settings{PRESET, {depth.width, depth.height}, radius, kind == "buffer"};
        gloam_camera camera{};
        std::ranges::copy(numbers_of(json, "proj_vk"), camera.projection);
        std::ranges::copy(numbers_of(json, "view"), camera.view);
        const gloam_error error =
            gloam_next(&frame, settings, camera, motion.empty() ? nullptr : motion.data());
        if (error != gloam_fine) throw std::runtime_error(name + ": gloam_error " + std::to_string(error));
        Picture picture{depth.width, depth.height, 1, std::vector<float>(depth.values.size())};
        const std::vector<unsigned char> shown = draw(frame, depth, normal);
        for (std::size_t i = 0; i < depth.values.size(); ++i)
            picture.values[i] = static_cast<float>(shown[i]) / 255.0F;
        write_pfm(out + name + "_ao.pfm", picture);
    }
}

inline int run_example(int count, char** arguments, void (*run)(char**)) {
    try {
        if (count != 5) throw std::runtime_error("expected GBUFFERS OUT RADIUS linear|buffer");
        run(arguments + 1);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
        return 2;
    }
}
