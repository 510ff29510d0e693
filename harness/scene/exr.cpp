// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <stdexcept>
#include <string>

#include "scene/internal/exr.hpp"

namespace gloam::scene {
namespace {

using Names = std::vector<std::string>;

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
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    FloatImage image{.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)},
                     .channels = channels};
    image.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(channels));
    const Names names = choose(input.header().channels(), channels);
    const auto pixel = static_cast<std::size_t>(channels) * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < names.size(); ++i) {
        // Slice::Make does the arithmetic for a window that does not begin at the origin.
        frame.insert(names[i], Imf::Slice::Make(Imf::FLOAT, image.texels.data() + i, window, pixel,
                                                pixel * static_cast<std::size_t>(width)));
    }
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return image;
}

}  // namespace

FloatImage read_exr(const std::filesystem::path& file, int channels) {
    try {
        return read(file.string(), channels);
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

}  // namespace gloam::scene
