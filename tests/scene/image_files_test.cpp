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

// 3 x 2, the bottom row first in the file.
const std::vector<float> bottom_first{
    4.0F, 5.0F, -0.0F, 1.0F, 0x1.fffffep127F, std::numeric_limits<float>::infinity()};
const std::vector<float> top_first{1.0F, 0x1.fffffep127F, std::numeric_limits<float>::infinity(), 4.0F, 5.0F,
                                   -0.0F};

TEST(Pfm, BothByteOrdersRowsFromTheBottom) {
    const TemporaryDirectory folder;
    for (const bool little : {false, true}) {
        const std::string header = little ? "Pf\n3 2\n-1.0\n" : "Pf\n3 2\n1.0\n";
        const auto image = read_pfm(folder.write("a.pfm", header + bytes(bottom_first, little)));
        EXPECT_EQ(image.extent, (gpu::Extent{3, 2}));
        EXPECT_EQ(image.channels, 1);
        EXPECT_EQ(bits(image.texels), bits(top_first)) << header;
    }
}

TEST(Pfm, ThreeChannels) {
    const TemporaryDirectory folder;
    const auto image = read_pfm(folder.write("a.pfm", "PF 1 2 -2.5\n" + bytes({4, 5, 6, 1, 2, 3}, true)));
    EXPECT_EQ(image.extent, (gpu::Extent{1, 2}));
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.texels, (std::vector<float>{1, 2, 3, 4, 5, 6}));  // only the scale's sign counts
}

TEST(Pfm, OnePixel) {
    const TemporaryDirectory folder;
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n" + bytes({0.25F}, true)));
    EXPECT_EQ(image.extent, (gpu::Extent{1, 1}));
    EXPECT_EQ(image.texels, std::vector{0.25F});
}

// The first byte of the texels may look like white space.
TEST(Pfm, OneWhiteSpaceEndsTheHeader) {
    const TemporaryDirectory folder;
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n\n\n\n\n"));
    EXPECT_EQ(bits(image.texels), std::vector{0x0A0A0A0AU});
}

TEST(Pfm, WrongLengths) {
    const TemporaryDirectory folder;
    const std::string header = "Pf\n3 2\n-1.0\n";
    const std::string texels = bytes(bottom_first, true);
    const auto short_by_one = folder.write("short.pfm", header + texels.substr(1));
    expect_error<std::runtime_error>([&] { (void)read_pfm(short_by_one); },
                                     {"short.pfm", "cut short", "24", "23"});
    const auto header_only = folder.write("header.pfm", header);
    expect_error<std::runtime_error>([&] { (void)read_pfm(header_only); },
                                     {"header.pfm", "cut short", "24", "0"});
    const auto too_long = folder.write("long.pfm", header + texels + "x");
    expect_error<std::runtime_error>([&] { (void)read_pfm(too_long); }, {"long.pfm", "too long", "24", "25"});
}

// Sizes whose product overflows must not be believed.
TEST(Pfm, HugeSizes) {
    const TemporaryDirectory folder;
    for (const char* size : {"1048576 1048576", "4294967297 1", "65536 65537", "99999999999999999999 1"}) {
        const auto file = folder.write("huge.pfm", std::string("PF\n") + size + "\n-1\n1234");
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"huge.pfm"});
    }
}

TEST(Pfm, NotOne) {
    const TemporaryDirectory folder;
    for (const char* text : {"", "P5\n1 1\n255\n0", "Pf", "Pf\n0 1\n-1\n", "Pf\n-1 1\n-1\n",
                             "Pf\n1 1\n0\n1234", "Pf\n1 1\nnan\n1234", "Pf\nx 1\n-1\n1234", "\x89PNG\r\n"}) {
        const auto file = folder.write("bad.pfm", text);
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"bad.pfm", "not a PFM"});
    }
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path() / "none.pfm"); }, {"none.pfm"});
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path()); }, {folder.path().c_str()});
}

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
            EXPECT_EQ(image.extent, (gpu::Extent{3, 2}));
            EXPECT_EQ(image.channels, 1);
            EXPECT_EQ(image.texels, six);
        }
        write_exr(file, 1, 2, {"R", "G", "B"}, six, type);
        const auto image = read_exr(file, 3);
        EXPECT_EQ(image.extent, (gpu::Extent{1, 2}));
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
