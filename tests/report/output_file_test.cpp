// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "support/files.hpp"
#include "support/full_disk.hpp"

namespace gloam::report {
namespace output_file_test {

namespace fs = std::filesystem;

auto names(const fs::path& path) {
    return testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(path.string()));
}

TEST(OutputFile, ReplacesAFileAsAWhole) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a.json";
    std::ofstream(path) << "something longer than what comes";
    const OutputFile file(path);
    EXPECT_EQ(test::read_file(path),
              "something longer than what comes");  // untouched until there is something to write
    file.write("new");
    EXPECT_EQ(test::read_file(path), "new");
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
}

TEST(OutputFile, AnEmptyPathWritesNothing) {
    const OutputFile file{fs::path{}};
    EXPECT_NO_THROW(file.write("text"));
}

TEST(OutputFile, WhatCannotBeWrittenIsNamedBeforeTheWork) {
    const test::TemporaryDirectory scratch;
    const fs::path missing = scratch.path() / "no" / "a.json";
    EXPECT_THAT([&] { OutputFile file(missing); }, names(missing));
    EXPECT_THAT([&] { OutputFile file(scratch.path()); }, names(scratch.path()));
}

TEST(OutputFile, ALinkStaysOne) {
    const test::TemporaryDirectory scratch;
    const fs::path target = scratch.path() / "target";
    const fs::path link = scratch.path() / "link";
    std::ofstream(target) << "something longer than what comes";
    fs::create_symlink(target, link);
    OutputFile(link).write("new");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(test::read_file(target), "new");
}

// What a link leads to is replaced as a whole, too.
TEST(OutputFile, WhatALinkLeadsToIsNeverHalfWritten) {
    const test::TemporaryDirectory scratch;
    const fs::path target = scratch.path() / "target";
    const fs::path link = scratch.path() / "link";
    std::ofstream(target) << "precious";
    fs::create_symlink("target", link);
    const OutputFile file(link);
    {
        const test::FullDisk disk(1000);
        EXPECT_THAT([&] { file.write(std::string(5000, 'x')); }, names(target));
    }
    EXPECT_EQ(test::read_file(target), "precious");
}

TEST(OutputFile, OpenFilesAreWrittenTo) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a";
    std::FILE* open = std::fopen(path.c_str(), "w");
    OutputFile("/proc/self/fd/" + std::to_string(fileno(open))).write("text");
    std::fclose(open);
    EXPECT_EQ(test::read_file(path), "text");
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1);
}

TEST(OutputFile, AFullDiskIsNamedAndLeavesNothing) {
    const OutputFile full("/dev/full");
    EXPECT_THAT([&] { full.write("text"); }, names("/dev/full"));
}

TEST(OutputFile, AFolderThatCameInTheWayIsNamedAndNothingIsLeftBeside) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a.json";
    const OutputFile file(path);
    fs::create_directories(path / "below");
    EXPECT_THAT([&] { file.write("text"); }, names(path));
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
    EXPECT_TRUE(fs::exists(path / "below"));
}

}  // namespace output_file_test
}  // namespace gloam::report
