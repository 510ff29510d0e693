// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <limits>

#include "scene/image_files.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::image_files_test {

namespace fs = std::filesystem;

// Writes `names.size()` channels, interleaved in `texels`, rows from the top, in a window that begins at
// `origin`.
void write_exr(const fs::path& file, int width, int height, const std::vector<const char*>& names,
               std::vector<float> texels, Imf::PixelType type = Imf::FLOAT, Imath::V2i origin = {0, 0}) {
    const Imath::Box2i window(origin, origin + Imath::V2i(width - 1, height - 1));
    Imf::Header header(window, window);
    std::vector<half> halves(texels.begin(), texels.end());
    const std::size_t bytes = type == Imf::HALF ? sizeof(half) : sizeof(float);
    char* data =
        type == Imf::HALF ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(texels.data());
    Imf::FrameBuffer frame;
    const std::size_t pixel = names.size() * bytes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        header.channels().insert(names[i], Imf::Channel(type));
        frame.insert(names[i], Imf::Slice::Make(type, data + i * bytes, window, pixel,
                                                pixel * static_cast<std::size_t>(width)));
    }
    Imf::OutputFile output(file.c_str(), header);
    output.setFrameBuffer(frame);
    output.writePixels(height);
}

// Values that half precision holds.
const std::vector<float> six{1.0F, -0.5F, 2048.0F, 0.25F, 65504.0F, 0x1p-24F};

TEST(Exr, FloatAndHalf) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    for (const auto type : {Imf::FLOAT, Imf::HALF}) {
        for (const char* name : {"Y", "R"}) {
            write_exr(file, 3, 2, {name}, six, type);
            const auto image = read_exr(file, 1);
            EXPECT_EQ(image.width, 3U);
            EXPECT_EQ(image.height, 2U);
            EXPECT_EQ(image.channels, 1);
            EXPECT_EQ(image.texels, six);
        }
        write_exr(file, 1, 2, {"R", "G", "B"}, six, type);
        const auto image = read_exr(file, 3);
        EXPECT_EQ(image.width, 1U);
        EXPECT_EQ(image.height, 2U);
        EXPECT_EQ(image.channels, 3);
        EXPECT_EQ(image.texels, six);
    }
}

TEST(Exr, FloatKeepsEveryBit) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    const std::vector<float> values{0.1F, -0.0F, 0x1.fffffep127F, 0x1p-149F};
    write_exr(file, 2, 2, {"Y"}, values);
    EXPECT_EQ(bits(read_exr(file, 1).texels), bits(values));
}

TEST(Exr, AWindowAwayFromTheOrigin) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    for (const Imath::V2i& origin : {Imath::V2i(100, 50), Imath::V2i(-7, -3)}) {
        write_exr(file, 2, 3, {"Y"}, six, Imf::FLOAT, origin);
        EXPECT_EQ(read_exr(file, 1).texels, six);
    }
}

TEST(Exr, OtherChannelsAreNotRead) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 1, 1, {"A", "R", "G", "B"}, {9, 1, 2, 3});
    EXPECT_EQ(read_exr(file, 3).texels, (std::vector<float>{1, 2, 3}));
}

TEST(Exr, WhatIsMissing) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 1, 1, {"Q", "S"}, {1, 2});
    expect_error<std::runtime_error>([&] { (void)read_exr(file, 1); }, {"a.exr", "expected", "Q, S"});
    expect_error<std::runtime_error>([&] { (void)read_exr(file, 3); }, {"a.exr", "R, G, B", "Q, S"});
    expect_error<std::runtime_error>([&] { (void)read_exr(folder.path() / "none.exr", 1); }, {"none.exr"});
}

TEST(Exr, Damaged) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 64, 64, {"Y"}, std::vector<float>(64 * 64, 0.5F));
    const std::string whole = read_file(file);
    for (const std::size_t length : {std::size_t{0}, std::size_t{3}, std::size_t{40}, whole.size() / 2}) {
        const auto cut = folder.write("cut.exr", whole.substr(0, length));
        expect_error<std::runtime_error>([&] { (void)read_exr(cut, 1); }, {"cut.exr"});
    }
    const auto text = folder.write("text.exr", "this is no image at all\n");
    expect_error<std::runtime_error>([&] { (void)read_exr(text, 1); }, {"text.exr"});
}

}  // namespace gloam::scene::test::image_files_test
