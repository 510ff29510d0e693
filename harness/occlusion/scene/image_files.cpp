// SPDX-License-Identifier: MIT
#include "scene/image_files.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/process.hpp"

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

namespace {

using Names = std::vector<std::string>;

constexpr std::int64_t longest_side = 65'536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

Names all_names(const Imf::ChannelList& channels) {
    Names names;
    for (auto i = channels.begin(); i != channels.end(); ++i) names.emplace_back(i.name());
    return names;
}

bool has_all(const Imf::ChannelList& channels, const Names& names) {
    for (const std::string& name : names) {
        if (channels.findChannel(name) == nullptr) return false;
    }
    return true;
}

Names choose(const Imf::ChannelList& channels, int count) {
    const std::vector<Names> known = count == 1 ? std::vector<Names>{{"Y"}, {"Z"}, {"R"}, {"depth"}}
                                                : std::vector<Names>{{"R", "G", "B"}, {"X", "Y", "Z"}};
    for (const Names& names : known) {
        if (has_all(channels, names)) return names;
    }
    const Names found = all_names(channels);
    if (count == 1 && found.size() == 1) return found;
    std::string text;
    for (const std::string& name : found) text += (text.empty() ? "" : ", ") + name;
    throw std::runtime_error(
        (count == 1 ? "expected one channel (Y, Z, R or depth)" : "expected channels R, G, B or X, Y, Z") +
        (", found " + text));
}

FloatImage read(const std::string& file, int channels) {
    Imf::InputFile input(file.c_str());
    const Imath::Box2i window = input.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > longest_side || height > longest_side ||
        width * height > most_pixels)
        throw std::runtime_error("a data window of " + std::to_string(width) + " x " +
                                 std::to_string(height) + ", expected sides of 1 to " +
                                 std::to_string(longest_side) + " and at most " +
                                 std::to_string(most_pixels) + " pixels");
    FloatImage image{.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)},
                     .channels = channels};
    image.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(channels));
    const Names names = choose(input.header().channels(), channels);
    const auto pixel = static_cast<std::size_t>(channels) * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < names.size(); ++i) {
        // Slice::Make handles a window that does not begin at the origin.
        frame.insert(names[i], Imf::Slice::Make(Imf::FLOAT, image.texels.data() + i, window, pixel,
                                                pixel * static_cast<std::size_t>(width)));
    }
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return image;
}

std::string bytes_of(const FloatImage& image) {
    std::string bytes(reinterpret_cast<const char*>(&image.extent), sizeof image.extent);
    bytes.append(reinterpret_cast<const char*>(image.texels.data()), image.texels.size() * sizeof(float));
    return bytes;
}

}  // namespace

FloatImage read_exr(const std::filesystem::path& file, int channels) {
    // The library may crash on a malformed file, so it reads in another process, within limits.
    const base::ProcessLimits limits{.memory_bytes = std::uint64_t{8} << 30,
                                     .cpu = std::chrono::seconds(60),
                                     .patience = std::chrono::minutes(10)};
    FloatImage image{.extent = {}, .channels = channels};
    std::string bytes;
    try {
        bytes = base::run_apart([&] { return bytes_of(read(file.string(), channels)); }, limits);
    } catch (const base::LimitError& error) {
        throw std::runtime_error(file.string() + ": cannot be read: its reader " + error.what());
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
    std::memcpy(&image.extent, bytes.data(), sizeof image.extent);
    image.texels.resize((bytes.size() - sizeof image.extent) / sizeof(float));
    std::memcpy(image.texels.data(), bytes.data() + sizeof image.extent, image.texels.size() * sizeof(float));
    return image;
}

namespace {

float sane(float value) {
    return value > 0.0F && std::isfinite(value) ? value : 0.0F;
}

FloatImage read(const std::filesystem::path& file) {
    if (file.extension() == ".pfm") return read_pfm(file);
    if (file.extension() == ".exr") return read_exr(file, 3);
    throw std::runtime_error(file.string() + ": expected an environment as .exr or .pfm");
}

}  // namespace

Environment constant_environment(const glm::vec3& radiance) {
    return {.extent = {1, 1}, .radiance = {radiance}};
}

Environment sky_environment() {
    constexpr std::uint32_t rows = 128;
    const glm::vec3 zenith(0.35F, 0.6F, 1.0F);
    const glm::vec3 horizon(1.0F, 1.0F, 1.0F);
    const glm::vec3 ground(0.25F, 0.22F, 0.18F);
    Environment sky{.extent = {1, rows}, .radiance = {}};
    for (std::uint32_t row = 0; row < rows; ++row) {
        const float height = static_cast<float>(std::cos((row + 0.5) * std::numbers::pi / rows));
        sky.radiance.push_back(height > 0.0F ? glm::mix(horizon, zenith, height) : ground);
    }
    return sky;
}

Environment read_environment(const std::filesystem::path& file) {
    const FloatImage image = read(file);
    if (image.channels != 3) throw std::runtime_error(file.string() + ": has 1 channel, expected 3");
    Environment environment{.extent = image.extent, .radiance = {}};
    for (std::size_t i = 0; i + 2 < image.texels.size(); i += 3) {
        environment.radiance.emplace_back(sane(image.texels[i]), sane(image.texels[i + 1]),
                                          sane(image.texels[i + 2]));
    }
    return environment;
}

}  // namespace gloam::scene
