// SPDX-License-Identifier: MIT
#include "scene/read_gbuffer.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "scene/internal/bytes.hpp"

namespace gloam::scene {
namespace {

using Names = std::vector<std::string>;

constexpr std::int64_t longest_side = 65'536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

// The first known set of names of which the file has all; for one channel its only one, whatever its name.
Names choose(const Imf::ChannelList& channels, int count) {
    const std::vector<Names> known = count == 1 ? std::vector<Names>{{"Y"}, {"Z"}, {"R"}, {"depth"}}
                                                : std::vector<Names>{{"R", "G", "B"}, {"X", "Y", "Z"}};
    Names found;
    for (auto i = channels.begin(); i != channels.end(); ++i) found.emplace_back(i.name());
    for (const Names& names : known)
        if (std::ranges::all_of(names,
                                [&](const auto& name) { return channels.findChannel(name) != nullptr; }))
            return names;
    if (count == 1 && found.size() == 1) return found;
    throw std::runtime_error(
        fmt::format("expected {}, found {}",
                    count == 1 ? "one channel (Y, Z, R or depth)" : "channels R, G, B or X, Y, Z",
                    fmt::join(found, ", ")));
}

base::FloatImage read(const std::string& file, int channels) {
    Imf::InputFile input(file.c_str());
    const Imath::Box2i window = input.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > longest_side || height > longest_side ||
        width * height > most_pixels)
        throw std::runtime_error(
            fmt::format("a data window of {} x {}, expected sides of 1 to {} and at most {} pixels", width,
                        height, longest_side, most_pixels));
    base::FloatImage image{.width = static_cast<std::uint32_t>(width),
                           .height = static_cast<std::uint32_t>(height),
                           .channels = channels,
                           .texels = {}};
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

}  // namespace

base::FloatImage read_exr(const std::filesystem::path& file, int channels) {
    // The library may crash on a malformed file, so it reads in another process, within limits.
    const base::ProcessLimits limits{.memory_bytes = std::uint64_t{8} << 30,
                                     .cpu = std::chrono::seconds(60),
                                     .patience = std::chrono::minutes(10)};
    const auto work = [&] {
        const base::FloatImage image = read(file.string(), channels);
        return bytes_of(std::vector{image.width, image.height}, image.texels);
    };
    try {
        std::vector<std::uint32_t> size;
        base::FloatImage image{.channels = channels};
        read_bytes(base::run_apart(work, limits), size, image.texels);
        image.width = size.at(0);
        image.height = size.at(1);
        return image;
    } catch (const base::LimitError& error) {
        throw std::runtime_error(file.string() + ": cannot be read: its reader " + error.what());
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

}  // namespace gloam::scene
