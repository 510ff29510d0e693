// SPDX-License-Identifier: MIT
#include "scene/pfm.hpp"

#include <limits>

#include "scene/support.hpp"

namespace gloam::scene::test {
namespace pfm_test {

// 3 x 2, the bottom row first in the file.
const std::vector<float> bottom_first{
    4.0F, 5.0F, -0.0F, 1.0F, 0x1.fffffep127F, std::numeric_limits<float>::infinity()};
const std::vector<float> top_first{1.0F, 0x1.fffffep127F, std::numeric_limits<float>::infinity(), 4.0F, 5.0F,
                                   -0.0F};

TEST(Pfm, BothByteOrdersRowsFromTheBottom) {
    const Folder folder;
    for (const bool little : {false, true}) {
        const std::string header = little ? "Pf\n3 2\n-1.0\n" : "Pf\n3 2\n1.0\n";
        const auto image = read_pfm(folder.write("a.pfm", header + bytes(bottom_first, little)));
        EXPECT_EQ(image.extent, (gpu::Extent{3, 2}));
        EXPECT_EQ(image.channels, 1);
        EXPECT_EQ(bits(image.texels), bits(top_first)) << header;
    }
}

TEST(Pfm, ThreeChannels) {
    const Folder folder;
    const auto image = read_pfm(folder.write("a.pfm", "PF 1 2 -2.5\n" + bytes({4, 5, 6, 1, 2, 3}, true)));
    EXPECT_EQ(image.extent, (gpu::Extent{1, 2}));
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.texels, (std::vector<float>{1, 2, 3, 4, 5, 6}));  // only the scale's sign counts
}

TEST(Pfm, OnePixel) {
    const Folder folder;
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n" + bytes({0.25F}, true)));
    EXPECT_EQ(image.extent, (gpu::Extent{1, 1}));
    EXPECT_EQ(image.texels, std::vector{0.25F});
}

// The first byte of the texels may look like white space.
TEST(Pfm, OneWhiteSpaceEndsTheHeader) {
    const Folder folder;
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n\n\n\n\n"));
    EXPECT_EQ(bits(image.texels), std::vector{0x0A0A0A0AU});
}

TEST(Pfm, WrongLengths) {
    const Folder folder;
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
    const Folder folder;
    for (const char* size : {"1048576 1048576", "4294967297 1", "65536 65537", "99999999999999999999 1"}) {
        const auto file = folder.write("huge.pfm", std::string("PF\n") + size + "\n-1\n1234");
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"huge.pfm"});
    }
}

TEST(Pfm, NotOne) {
    const Folder folder;
    for (const char* text : {"", "P5\n1 1\n255\n0", "Pf", "Pf\n0 1\n-1\n", "Pf\n-1 1\n-1\n",
                             "Pf\n1 1\n0\n1234", "Pf\n1 1\nnan\n1234", "Pf\nx 1\n-1\n1234", "\x89PNG\r\n"}) {
        const auto file = folder.write("bad.pfm", text);
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"bad.pfm", "not a PFM"});
    }
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path() / "none.pfm"); }, {"none.pfm"});
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path()); }, {folder.path().c_str()});
}

}  // namespace pfm_test
}  // namespace gloam::scene::test
