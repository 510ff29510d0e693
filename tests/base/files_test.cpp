// SPDX-License-Identifier: MIT
#include "base/files.hpp"
#include "base/image_files.hpp"
#include "support/files.hpp"
#include "support/full_disk.hpp"
#include "support/run_command.hpp"

namespace gloam::base::files_test {

TEST(ReadFile, IsEveryByteOrNamesWhatCannotBeRead) {
    const test::TemporaryDirectory scratch;
    const std::string bytes("a\0b\r\n\xff", 6);
    const auto path = scratch.write("a", bytes);
    EXPECT_EQ(read_file(path), bytes);
    EXPECT_EQ(read_file(path, bytes.size()), bytes);
    const auto refuse = [](const std::filesystem::path& file, const std::string& why) {
        expect_error<std::runtime_error>([&] { (void)read_file(file, 100'000); }, {file.string(), why});
    };
    refuse(scratch.path() / "none", "No such file");
    refuse(scratch.path(), "Is a directory");
    refuse("/dev/zero", "/dev/zero: it is longer than 100000 bytes");
}

namespace fs = std::filesystem;

std::size_t count_files(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

using WriteFile = InFolder;

TEST_F(WriteFile, MakesAndReplaces) {
    const fs::path path = folder.path() / std::string(255, 'n');  // as long as names can be
    for (const char* text : {"something long", "new"}) {
        write_file(path, text);
        EXPECT_EQ(test::read_file(path), text);
    }
    EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST_F(WriteFile, ALinkIsReplacedAndNotFollowed) {
    const fs::path victim = folder.path() / "victim";
    const fs::path path = folder.path() / "a";
    write_file(victim, "precious");
    fs::create_symlink(victim, path);
    fs::create_symlink(victim, folder.path() / "a.part");  // a name that once was used
    write_file(path, "new");
    EXPECT_EQ(test::read_file(victim), "precious");
    EXPECT_FALSE(fs::is_symlink(path));
    EXPECT_EQ(test::read_file(path), "new");
}

TEST_F(WriteFile, AFullDiskIsNamedAndLeavesNothing) {
    const fs::path path = folder.path() / "a";
    const test::FullDisk disk(1000);
    expect_error<std::runtime_error>([&] { write_file(path, std::string(5000, 'x')); },
                                     {path.string(), "File too large"});
    EXPECT_EQ(count_files(folder.path()), 0U);
}

// Each write is whole, whoever comes last.
TEST_F(WriteFile, ManyAtOnceNeverMixAndNeverFail) {
    const fs::path path = folder.path() / "a";
    constexpr std::size_t bytes = 100'000;
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'}) {
        writers.emplace_back([&, letter] {
            for (int i = 0; i < 20; ++i) EXPECT_NO_THROW(write_file(path, std::string(bytes, letter)));
        });
    }
    for (std::thread& writer : writers) writer.join();
    const std::string text = test::read_file(path);
    ASSERT_EQ(text.size(), bytes);
    EXPECT_EQ(text, std::string(bytes, text.front()));
    EXPECT_EQ(count_files(folder.path()), 1U);
}

// 3 x 2, the bottom row first in the file.
const std::vector<float> bottom_first{4.0F, 5.0F, -0.0F, 1.0F, 0x1.fffffep127F, infinity};
const std::vector<float> top_first{1.0F, 0x1.fffffep127F, infinity, 4.0F, 5.0F, -0.0F};

using PfmReader = InFolder;

TEST_F(PfmReader, BothByteOrdersRowsFromTheBottom) {
    for (const bool little : {false, true}) {
        const std::string header = little ? "Pf\n3 2\n-1.0\n" : "Pf\n3 2\n1.0\n";
        const auto image = read_pfm(folder.write("a.pfm", header + bytes(bottom_first, little)));
        EXPECT_EQ(image.width, 3U);
        EXPECT_EQ(image.height, 2U);
        EXPECT_EQ(image.channels, 1);
        EXPECT_EQ(bits(image.texels), bits(top_first)) << header;
    }
}

// Of three channels; and the first byte of the texels may look like white space, of which one ends the
// header.
TEST_F(PfmReader, OneWhiteSpaceEndsTheHeader) {
    const auto image = read_pfm(folder.write("a.pfm", "PF 1 2 -2.5\n" + bytes({4, 5, 6, 1, 2, 3}, true)));
    EXPECT_EQ(image.height, 2U);
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.texels, (std::vector<float>{1, 2, 3, 4, 5, 6}));  // only the scale's sign counts
    EXPECT_EQ(bits(read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n\n\n\n\n")).texels),
              std::vector{0x0A0A0A0AU});
}

// Sizes whose product overflows must not be believed.
TEST_F(PfmReader, WhatIsNoneIsNamed) {
    const std::string texels = bytes(bottom_first, true);
    const auto refuse = [&](const std::string& text, const std::string& why) {
        const auto file = folder.write("bad.pfm", text);
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"bad.pfm", why});
    };
    refuse("Pf\n3 2\n-1.0\n" + texels.substr(1), "cut short: expected 24 bytes of texels, found 23");
    refuse("Pf\n3 2\n-1.0\n", "cut short: expected 24 bytes of texels, found 0");
    refuse("Pf\n3 2\n-1.0\n" + texels + "x", "too long: expected 24 bytes of texels, found 25");
    for (const char* size : {"1048576 1048576", "4294967297 1", "65536 65537", "99999999999999999999 1"})
        refuse(std::string("PF\n") + size + "\n-1\n1234", "");
    for (const char* text : {"", "P5\n1 1\n255\n0", "Pf", "Pf\n0 1\n-1\n", "Pf\n-1 1\n-1\n",
                             "Pf\n1 1\n0\n1234", "Pf\n1 1\nnan\n1234", "Pf\nx 1\n-1\n1234", "\x89PNG\r\n"})
        refuse(text, "not a PFM");
    for (const fs::path& file : {path("none.pfm"), folder.path()})
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {file.string()});
}

TEST_F(PfmReader, ReadsWhatIsWritten) {
    EXPECT_EQ(to_pfm(top_first, 3, 2, 1), "Pf\n3 2\n-1.0\n" + bytes(bottom_first, true));
    EXPECT_EQ(read_pfm(folder.write("a.pfm", to_pfm(top_first, 1, 2, 3))).channels, 3);
    EXPECT_THROW((void)to_pfm(std::vector<float>(3), 2, 2, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(), 0, 0, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(8), 2, 2, 2), std::invalid_argument);
}

// Only the magnitude counts, up to the end of the scale.
TEST(HeatMap, IsAPictureOfErrors) {
    const auto of = [](float error) { return to_png(heat_rgb(std::vector<float>{error}, 0.25), 1, 1); };
    EXPECT_THAT(of(0.0F), StartsWith("\x89PNG"));
    EXPECT_EQ(of(0.3F), of(-9.0F));
    EXPECT_NE(of(0.1F), of(0.2F));
    EXPECT_NE(of(0.0F), of(nan));
    const std::vector<float> four(4);
    EXPECT_THROW((void)to_png(heat_rgb(four, 0.25), 2, 3), std::invalid_argument);
    EXPECT_THROW((void)heat_rgb(four, 0.0), std::invalid_argument);
    EXPECT_THROW((void)to_png(std::vector<std::uint8_t>(5), 1, 2), std::invalid_argument);
    const std::uint8_t byte = 0;
    const std::span wide(&byte, std::size_t{3} << 30U);  // none of it is read
    EXPECT_THROW((void)to_png(wide, 1U << 15U, 1U << 15U), std::invalid_argument);
}

}  // namespace gloam::base::files_test
