// SPDX-License-Identifier: MIT
#include "base/image_files.hpp"

#include <byteswap.h>
#include <stb_image_write.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <numbers>
#include <stdexcept>

#include "base/text.hpp"

// Of stb.cpp; its header declares what makes files alone.
extern "C" unsigned char* stbi_zlib_compress(unsigned char* data, int size, int* packed_size, int quality);

namespace gloam::base {

namespace {

using Triple = std::array<double, 3>;
using Color = std::array<std::uint8_t, 3>;

// Linear sRGB of a colour in Oklab (Ottosson 2020).
Triple linear_from_oklab(double lightness, double a, double b) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::uint8_t encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * srgb));
}

// The colour of an error on a scale from 0 to 1.
Color heat_color(double value) {
    const double t = value > 0.0 ? std::min(value, 1.0) : 0.0;
    const double lightness = 0.08 + 0.89 * t;
    const double hue = (285.0 + 180.0 * t) * std::numbers::pi / 180.0;
    // Reduces the chroma until the colour is displayable, because the lightness must not change.
    Triple rgb{};
    for (double chroma = 0.18; chroma > -0.005; chroma -= 0.005) {
        rgb = linear_from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
        if (std::ranges::all_of(rgb, [](double x) { return x >= 0.0 && x <= 1.0; })) break;
    }
    return {encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2])};
}

void require_texels(std::size_t found, std::uint32_t width, std::uint32_t height, int channels) {
    const std::size_t expected = std::size_t{width} * height * static_cast<std::size_t>(channels);
    if (found == expected && expected > 0) return;
    throw std::invalid_argument("image of " + std::to_string(width) + " x " + std::to_string(height) + " x " +
                                std::to_string(channels) + ": " + std::to_string(found) + " values");
}

void append_bytes(void* out, void* data, int size) {
    static_cast<std::string*>(out)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

namespace fs = std::filesystem;

[[noreturn]] void fail_with_file(const fs::path& file, const std::string& what) {
    throw std::runtime_error(file.string() + ": " + what);
}

// An image without its texels, and whether these are little-endian. Reads four words, each followed by one
// white-space character; the texels begin behind the last.
std::pair<FloatImage, bool> read_header(std::ifstream& stream, const fs::path& file) {
    std::string kind;
    std::int64_t width = 0;
    std::int64_t height = 0;
    double scale = 0.0;
    stream >> std::setw(2) >> kind >> width >> height >> scale;
    const int channels = kind == "Pf" ? 1 : (kind == "PF" ? 3 : 0);
    if (channels == 0) fail_with_file(file, "not a PFM: expected it to begin with Pf or PF");
    const auto is_side = [](std::int64_t side) { return side >= 1 && side <= 1 << 20; };
    if (!stream || !is_side(width) || !is_side(height) || !(scale < 0.0 || scale > 0.0))
        fail_with_file(file, "not a PFM: expected width, height and a scale that is not 0 behind " + kind);
    stream.get();
    return {{.width = static_cast<std::uint32_t>(width),
             .height = static_cast<std::uint32_t>(height),
             .channels = channels,
             .texels = {}},
            scale < 0.0};
}

void require_bytes(std::ifstream& stream, const fs::path& file, std::size_t wanted) {
    const auto here = stream.tellg();
    stream.seekg(0, std::ios::end);
    const auto there = static_cast<std::size_t>(stream.tellg() - here);
    if (there != wanted)
        fail_with_file(file, (there < wanted ? "cut short: expected " : "too long: expected ") +
                                 std::to_string(wanted) + " bytes of texels, found " + std::to_string(there));
    stream.seekg(here);
}

}  // namespace

std::string to_pfm(std::span<const float> texels, std::uint32_t width, std::uint32_t height, int channels) {
    static_assert(std::endian::native == std::endian::little);
    if (channels != 1 && channels != 3)
        throw std::invalid_argument("a PFM has 1 or 3 channels, not " + std::to_string(channels));
    require_texels(texels.size(), width, height, channels);
    std::string file = channels == 1 ? "Pf\n" : "PF\n";
    file += std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    const std::size_t row = std::size_t{width} * static_cast<std::size_t>(channels);
    file.reserve(file.size() + 4 * texels.size());
    for (std::size_t y = height; y-- > 0;)
        file.append(reinterpret_cast<const char*>(&texels[y * row]), row * sizeof(float));
    return file;
}

std::string to_png(std::span<const std::uint8_t> texels, std::uint32_t width, std::uint32_t height,
                   int channels) {
    require_texels(texels.size(), width, height, channels);
    constexpr std::uint64_t largest = std::numeric_limits<int>::max();  // bytes, which stb counts
    const std::uint64_t row = std::uint64_t{width} * static_cast<std::uint64_t>(channels) + 1U;
    if (row > largest || row * height > largest) throw std::invalid_argument("image too large for a PNG");
    std::string file;
    const int made =
        stbi_write_png_to_func(append_bytes, &file, static_cast<int>(width), static_cast<int>(height),
                               channels, texels.data(), channels * static_cast<int>(width));
    if (made == 0) throw std::runtime_error("cannot compress a PNG: out of memory");
    return file;
}

RgbBytes heat_rgb(std::span<const float> errors, double full) {
    if (!(full > 0.0)) throw std::invalid_argument("heat map: expected a scale > 0");
    constexpr std::uint8_t unknown = 96;
    RgbBytes rgb;
    rgb.reserve(3 * errors.size());
    for (const float error : errors) {
        const Color color =
            std::isnan(error) ? Color{unknown, unknown, unknown} : heat_color(std::abs(double{error}) / full);
        rgb.insert(rgb.end(), color.begin(), color.end());
    }
    return rgb;
}

RgbBytes srgb_of(std::span<const float> linear) {
    RgbBytes rgb;
    rgb.reserve(linear.size());
    for (const float value : linear) {
        const float v = value > 0.0F ? std::fmin(value, 1.0F) : 0.0F;
        const float coded = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
        rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0F * coded)));
    }
    return rgb;
}

FloatImage read_pfm(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::error_code none;
    if (!stream || fs::is_directory(file, none)) fail_with_file(file, "cannot be read");
    auto [image, little_endian] = read_header(stream, file);
    const std::size_t row = std::size_t{image.width} * static_cast<std::size_t>(image.channels);
    require_bytes(stream, file, row * image.height * sizeof(float));
    image.texels.resize(row * image.height);
    for (std::size_t y = image.height; y-- > 0;)  // rows come from the bottom
        stream.read(reinterpret_cast<char*>(image.texels.data() + y * row),
                    static_cast<std::streamsize>(row * sizeof(float)));
    if (!stream) fail_with_file(file, "cannot be read to its end");
    for (float& texel : image.texels)
        if (!little_endian) texel = std::bit_cast<float>(bswap_32(std::bit_cast<std::uint32_t>(texel)));
    return std::move(image);
}

std::string deflated_base64(std::span<const unsigned char> bytes) {
    if (bytes.empty()) return {};
    constexpr int quality = 16;
    int size = 0;
    std::vector<unsigned char> copy(bytes.begin(), bytes.end());
    unsigned char* packed = stbi_zlib_compress(copy.data(), static_cast<int>(copy.size()), &size, quality);
    if (packed == nullptr) throw std::bad_alloc();
    const std::string text = base64({packed, static_cast<std::size_t>(size)});
    std::free(packed);
    return text;
}

}  // namespace gloam::base
