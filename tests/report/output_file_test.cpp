// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/run_command.hpp"

namespace gloam::report {
namespace output_file_test {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

auto names(const fs::path& path) {
    return testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(path.string()));
}

TEST(OutputFile, ReplacesAFileAsAWhole) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a.json";
    std::ofstream(path) << "something longer than what comes";
    const OutputFile file(path);
    EXPECT_EQ(read(path), "something longer than what comes");  // untouched until there is something to write
    file.write("new");
    EXPECT_EQ(read(path), "new");
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
    EXPECT_EQ(read(target), "new");
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
