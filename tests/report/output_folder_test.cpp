// SPDX-License-Identifier: MIT
#include "report/output_folder.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

#include "support/run_command.hpp"

namespace gloam::report {
namespace output_folder_test {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing thrown";
}

TEST(OutputFolder, FilesAppearWhenKept) {
    const test::TemporaryDirectory scratch;
    const fs::path out = scratch.path() / "a" / "b";
    OutputFolder folder(out);
    folder.write("x", "one");
    EXPECT_FALSE(fs::exists(out / "x"));
    folder.write("y", "two");
    folder.keep();
    EXPECT_EQ(read(out / "x"), "one");
    EXPECT_EQ(read(out / "y"), "two");
    EXPECT_FALSE(fs::exists(out / "x.part"));
}

TEST(OutputFolder, NothingIsLeftOfWhatWasNotKept) {
    const test::TemporaryDirectory scratch;
    { OutputFolder(scratch.path() / "a" / "b").write("x", "one"); }
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(OutputFolder, WhatWasThereStaysUntilKept) {
    const test::TemporaryDirectory scratch;
    std::ofstream(scratch.path() / "x") << "old";
    { OutputFolder(scratch.path()).write("x", "new"); }
    EXPECT_EQ(read(scratch.path() / "x"), "old");
}

TEST(OutputFolder, AFullDiskIsNamedAndLeavesNothing) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const test::TemporaryDirectory scratch;
    fs::create_symlink("/dev/full", scratch.path() / "x.part");
    const std::string message = message_of([&] { OutputFolder(scratch.path()).write("x", "one"); });
    EXPECT_THAT(message, testing::HasSubstr((scratch.path() / "x").string()));
    EXPECT_THAT(message, testing::HasSubstr("No space left"));
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(OutputFolder, AFileInTheWayIsNamed) {
    const test::TemporaryDirectory scratch;
    const fs::path file = scratch.path() / "file";
    std::ofstream(file) << "x";
    EXPECT_THAT(message_of([&] { OutputFolder folder(file); }), testing::HasSubstr(file.string()));
    EXPECT_THAT(message_of([&] { OutputFolder folder(file / "below"); }), testing::HasSubstr(file.string()));
    EXPECT_THAT(message_of([&] { OutputFolder folder("/proc/gloam"); }), testing::HasSubstr("/proc/gloam"));
}

}  // namespace output_folder_test
}  // namespace gloam::report
