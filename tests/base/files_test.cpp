// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>

#include "base/files.hpp"
#include "base/image_files.hpp"
#include "support/files.hpp"
#include "support/full_disk.hpp"
#include "support/run_command.hpp"

namespace gloam::base::files_test {

TEST(ReadFile, IsEveryByte) {
    const test::TemporaryDirectory scratch;
    const auto path = scratch.path() / "a";
    const std::string bytes("a\0b\r\n\xff", 6);
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_EQ(read_file(path), bytes);
    EXPECT_EQ(read_file(path, bytes.size()), bytes);
}

TEST(ReadFile, WhatCannotBeReadIsNamed) {
    const test::TemporaryDirectory scratch;
    expect_error<std::runtime_error>([&] { (void)read_file(scratch.path() / "none"); },
                                     {"none", "No such file"});
    expect_error<std::runtime_error>([&] { (void)read_file(scratch.path()); },
                                     {scratch.path().string(), "Is a directory"});
}

TEST(ReadFile, ADeviceWithoutEndIsTooLong) {
    expect_error<std::runtime_error>([] { (void)read_file("/dev/zero", 100'000); },
                                     {"/dev/zero: it is longer than 100000 bytes"});
}

namespace fs = std::filesystem;

std::size_t count_files(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

using WriteFile = InFolder;

TEST_F(WriteFile, MakesAndReplaces) {
    const fs::path path = folder.path() / "a";
    write_file(path, "something long");
    EXPECT_EQ(test::read_file(path), "something long");
    write_file(path, "new");
    EXPECT_EQ(test::read_file(path), "new");
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

TEST_F(WriteFile, AMissingFolderIsNamed) {
    const fs::path path = folder.path() / "none" / "a";
    expect_error<std::runtime_error>([&] { write_file(path, "x"); }, {path.string(), "No such file"});
}

TEST_F(WriteFile, NamesAsLongAsNamesCanBe) {
    const fs::path path = folder.path() / std::string(255, 'n');
    write_file(path, "x");
    EXPECT_EQ(test::read_file(path), "x");
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

// In a child process, which may close what it likes.
int status_of(int (*work)()) {
    const pid_t child = fork();
    if (child == 0) _exit(work());
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(FileDescriptor, ConnectionsStayOffTheStandardStreams) {
    EXPECT_EQ(status_of([] {
                  close(STDIN_FILENO);
                  close(STDOUT_FILENO);
                  const auto [ours, theirs] = connected_pair();
                  return ours.get() > STDERR_FILENO && theirs.get() > STDERR_FILENO ? 0 : 1;
              }),
              0);
}

TEST(FileDescriptor, ReservedStreamsFailAndAreNobodyElses) {
    EXPECT_EQ(status_of([] {
                  close(STDIN_FILENO);
                  close(STDOUT_FILENO);
                  reserve_standard_streams();
                  const FileDescriptor file(open("/dev/null", O_RDONLY));
                  if (file.get() <= STDERR_FILENO) return 1;
                  char c = 'x';
                  if (write(STDOUT_FILENO, &c, 1) >= 0 || errno != EBADF) return 2;
                  if (read(STDIN_FILENO, &c, 1) >= 0 || errno != EBADF) return 3;
                  return 0;
              }),
              0);
}

TEST(FileDescriptor, OpenStreamsStayAsTheyAre) {
    EXPECT_EQ(status_of([] {
                  const int before = fcntl(STDOUT_FILENO, F_GETFL);
                  reserve_standard_streams();
                  return fcntl(STDOUT_FILENO, F_GETFL) == before ? 0 : 1;
              }),
              0);
}

namespace fs = std::filesystem;

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

TEST_F(PfmReader, ThreeChannels) {
    const auto image = read_pfm(folder.write("a.pfm", "PF 1 2 -2.5\n" + bytes({4, 5, 6, 1, 2, 3}, true)));
    EXPECT_EQ(image.width, 1U);
    EXPECT_EQ(image.height, 2U);
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.texels, (std::vector<float>{1, 2, 3, 4, 5, 6}));  // only the scale's sign counts
}

TEST_F(PfmReader, OnePixel) {
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n" + bytes({0.25F}, true)));
    EXPECT_EQ(image.width, 1U);
    EXPECT_EQ(image.height, 1U);
    EXPECT_EQ(image.texels, std::vector{0.25F});
}

// The first byte of the texels may look like white space.
TEST_F(PfmReader, OneWhiteSpaceEndsTheHeader) {
    const auto image = read_pfm(folder.write("a.pfm", "Pf\n1 1\n-1\n\n\n\n\n"));
    EXPECT_EQ(bits(image.texels), std::vector{0x0A0A0A0AU});
}

TEST_F(PfmReader, WrongLengths) {
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
TEST_F(PfmReader, HugeSizes) {
    for (const char* size : {"1048576 1048576", "4294967297 1", "65536 65537", "99999999999999999999 1"}) {
        const auto file = folder.write("huge.pfm", std::string("PF\n") + size + "\n-1\n1234");
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"huge.pfm"});
    }
}

TEST_F(PfmReader, NotOne) {
    for (const char* text : {"", "P5\n1 1\n255\n0", "Pf", "Pf\n0 1\n-1\n", "Pf\n-1 1\n-1\n",
                             "Pf\n1 1\n0\n1234", "Pf\n1 1\nnan\n1234", "Pf\nx 1\n-1\n1234", "\x89PNG\r\n"}) {
        const auto file = folder.write("bad.pfm", text);
        expect_error<std::runtime_error>([&] { (void)read_pfm(file); }, {"bad.pfm", "not a PFM"});
    }
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path() / "none.pfm"); }, {"none.pfm"});
    expect_error<std::runtime_error>([&] { (void)read_pfm(folder.path()); }, {folder.path().c_str()});
}

float float_at(const std::string& bytes, std::size_t offset) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(Pfm, RowsBottomFirstAndEveryBitKept) {
    const std::string file = to_pfm(std::vector<float>{1.0F, 2.0F, infinity, -0.0F}, 2, 2, 1);
    const std::string header = "Pf\n2 2\n-1.0\n";
    ASSERT_EQ(file.size(), header.size() + 16);
    EXPECT_EQ(file.substr(0, header.size()), header);
    EXPECT_EQ(float_at(file, header.size()), infinity);
    EXPECT_TRUE(std::signbit(float_at(file, header.size() + 4)));
    EXPECT_EQ(float_at(file, header.size() + 8), 1.0F);
    EXPECT_EQ(float_at(file, header.size() + 12), 2.0F);
}

TEST(Pfm, ThreeChannelsAreCalledPF) {
    EXPECT_EQ(to_pfm(std::vector<float>(3), 1, 1, 3).substr(0, 7), "PF\n1 1\n");
}

TEST(Pfm, WrongCountsAreRefused) {
    EXPECT_THROW((void)to_pfm(std::vector<float>(3), 2, 2, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(), 0, 0, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(8), 2, 2, 2), std::invalid_argument);
}

TEST(Png, IsOneWithTheSizeAskedFor) {
    const std::string file = to_png(std::vector<std::uint8_t>(15, 7), 5, 3);
    EXPECT_EQ(file.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
    EXPECT_EQ(file[19], 5);
    EXPECT_EQ(file[23], 3);
    EXPECT_EQ(file[24], 8);  // bits
    EXPECT_EQ(file[25], 0);  // grey
}

// Relative luminance of an sRGB colour.
double luminance(const Color& color) {
    const auto linear = [](std::uint8_t byte) {
        const double x = byte / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

TEST(ColorMap, GetsLighterAllTheWay) {
    double before = -1.0;
    for (int i = 0; i <= 64; ++i) {
        const double now = luminance(heat_color(i / 64.0));
        EXPECT_GT(now, before) << i;
        before = now;
    }
    EXPECT_LT(luminance(heat_color(0.0)), 0.01);
    EXPECT_GT(luminance(heat_color(1.0)), 0.8);
}

TEST(ColorMap, EndsAtItsEnds) {
    EXPECT_EQ(heat_color(-3.0), heat_color(0.0));
    EXPECT_EQ(heat_color(7.0), heat_color(1.0));
    EXPECT_EQ(heat_color(std::numeric_limits<double>::quiet_NaN()), heat_color(0.0));
}

TEST(HeatMap, IsAPictureOfErrors) {
    const std::vector<float> errors{0.0F, -0.25F, 0.1F, nan};
    EXPECT_THAT(to_heat_png(errors, 2, 2, 0.25), StartsWith("\x89PNG"));
    // Only the magnitude counts, up to the end of the scale.
    EXPECT_EQ(to_heat_png(std::vector<float>{0.3F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{-9.0F}, 1, 1, 0.25));
    EXPECT_NE(to_heat_png(std::vector<float>{0.1F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{0.2F}, 1, 1, 0.25));
    EXPECT_NE(to_heat_png(std::vector<float>{0.0F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{errors[3]}, 1, 1, 0.25));
    EXPECT_THROW((void)to_heat_png(errors, 2, 3, 0.25), std::invalid_argument);
    EXPECT_THROW((void)to_heat_png(errors, 2, 2, 0.0), std::invalid_argument);
    EXPECT_THROW((void)to_rgb_png(std::vector<std::uint8_t>(5), 1, 2), std::invalid_argument);
}

}  // namespace gloam::base::files_test
