// SPDX-License-Identifier: MIT
#include "scene/pfm.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_with_file(const fs::path& file, const std::string& what) {
    throw std::runtime_error(file.string() + ": " + what);
}

struct Header {
    FloatImage image;  // without texels
    bool little_endian = true;
    std::size_t bytes = 0;  // of all texels
};

// Reads four words, each followed by one white-space character; the texels begin behind the last.
Header read_header(std::ifstream& stream, const fs::path& file) {
    std::string kind;
    std::int64_t width = 0;
    std::int64_t height = 0;
    double scale = 0.0;
    stream >> kind >> width >> height >> scale;
    const int channels = kind == "Pf" ? 1 : (kind == "PF" ? 3 : 0);
    if (channels == 0) fail_with_file(file, "not a PFM: expected it to begin with Pf or PF");
    const auto is_side = [](std::int64_t side) { return side >= 1 && side <= 1 << 20; };
    if (!stream || !is_side(width) || !is_side(height) || !(scale < 0.0 || scale > 0.0)) {
        fail_with_file(file, "not a PFM: expected width, height and a scale that is not 0 behind " + kind);
    }
    stream.get();
    const gpu::Extent extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    Header header{.image = {.extent = extent, .channels = channels}, .little_endian = scale < 0.0};
    header.bytes =
        std::size_t{extent.width} * extent.height * static_cast<std::size_t>(channels) * sizeof(float);
    return header;
}

void require_bytes(std::ifstream& stream, const fs::path& file, std::size_t wanted) {
    const auto here = stream.tellg();
    stream.seekg(0, std::ios::end);
    const auto there = static_cast<std::size_t>(stream.tellg() - here);
    if (there != wanted) {
        fail_with_file(file, (there < wanted ? "cut short: expected " : "too long: expected ") +
                                 std::to_string(wanted) + " bytes of texels, found " + std::to_string(there));
    }
    stream.seekg(here);
}

void swap_bytes(std::vector<float>& texels) {
    for (float& texel : texels) {
        const auto bits = std::bit_cast<std::uint32_t>(texel);
        texel = std::bit_cast<float>(bits << 24 | (bits & 0xFF00U) << 8 | (bits >> 8 & 0xFF00U) | bits >> 24);
    }
}

}  // namespace

FloatImage read_pfm(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::error_code none;
    if (!stream || fs::is_directory(file, none)) fail_with_file(file, "cannot be read");
    Header header = read_header(stream, file);
    require_bytes(stream, file, header.bytes);
    FloatImage image = std::move(header.image);
    const std::size_t row = std::size_t{image.extent.width} * static_cast<std::size_t>(image.channels);
    image.texels.resize(row * image.extent.height);
    for (std::size_t y = image.extent.height; y-- > 0;) {  // rows come from the bottom
        stream.read(reinterpret_cast<char*>(image.texels.data() + y * row),
                    static_cast<std::streamsize>(row * sizeof(float)));
    }
    if (!stream) fail_with_file(file, "cannot be read to its end");
    if (header.little_endian != (std::endian::native == std::endian::little)) swap_bytes(image.texels);
    return image;
}

}  // namespace gloam::scene
