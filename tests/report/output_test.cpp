// SPDX-License-Identifier: MIT
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "report/output.hpp"
#include "support/files.hpp"
#include "support/full_disk.hpp"
#include "support/matchers.hpp"

namespace gloam::report::output_test {

namespace fs = std::filesystem;

auto names(const fs::path& path) {
    return ThrowsMessage<std::runtime_error>(HasSubstr(path.string()));
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
    EXPECT_EQ(test::read_file(out / "x"), "one");
    EXPECT_EQ(test::read_file(out / "y"), "two");
    EXPECT_FALSE(fs::exists(out / "x.part"));
}

TEST(OutputFolder, NothingIsLeftOfWhatWasNotKept) {
    const test::TemporaryDirectory scratch;
    {
        OutputFolder(scratch.path() / "a" / "b").write("x", "one");
    }
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(OutputFolder, WhatWasThereStaysUntilKept) {
    const test::TemporaryDirectory scratch;
    std::ofstream(scratch.path() / "x") << "old";
    {
        OutputFolder(scratch.path()).write("x", "new");
    }
    EXPECT_EQ(test::read_file(scratch.path() / "x"), "old");
}

TEST(OutputFolder, AFullDiskIsNamedAndLeavesNothing) {
    const test::TemporaryDirectory scratch;
    const test::FullDisk disk(1000);
    const std::string message =
        message_of([&] { OutputFolder(scratch.path()).write("x", std::string(5000, 'x')); });
    EXPECT_THAT(message, HasSubstr((scratch.path() / "x").string()));
    EXPECT_THAT(message, HasSubstr("File too large"));
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(OutputFolder, NoLinkIsFollowed) {
    const test::TemporaryDirectory scratch;
    const fs::path victim = scratch.path() / "victim";
    const fs::path out = scratch.path() / "out";
    fs::create_directory(out);
    std::ofstream(victim) << "precious";
    fs::create_symlink(victim, out / "x.part");
    fs::create_symlink(victim, out / "x");
    OutputFolder folder(out);
    folder.write("x", "one");
    folder.keep();
    EXPECT_EQ(test::read_file(victim), "precious");
    EXPECT_EQ(test::read_file(out / "x"), "one");
}

TEST(OutputFolder, NoNameLeadsOutOfIt) {
    const test::TemporaryDirectory scratch;
    OutputFolder folder(scratch.path() / "out");
    for (const char* name : {"../x", "/x", "a/b", "..", ".", ""})
        EXPECT_THROW(folder.write(name, "one"), std::invalid_argument) << name;
}

// Runs with one folder: each keeps its files all at once or not at all, and none fails for another.
TEST(OutputFolder, RunsWithOneFolderNeverMix) {
    const test::TemporaryDirectory scratch;
    const fs::path out = scratch.path() / "out";
    for (int round = 0; round < 25; ++round) {
        std::vector<std::thread> runs;
        for (const char* text : {"a", "b", "c"}) {
            runs.emplace_back([&out, text] {
                EXPECT_EQ(message_of([&] {
                              OutputFolder folder(out);
                              for (const char* name : {"x", "y", "z", "w"}) folder.write(name, text);
                              folder.keep();
                          }),
                          "nothing thrown");
            });
        }
        for (std::thread& run : runs) run.join();
        for (const char* name : {"y", "z", "w"})
            ASSERT_EQ(test::read_file(out / name), test::read_file(out / "x"));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 4);
}

TEST(OutputFolder, AFileInTheWayIsNamed) {
    const test::TemporaryDirectory scratch;
    const fs::path file = scratch.path() / "file";
    std::ofstream(file) << "x";
    EXPECT_THAT(message_of([&] { OutputFolder folder(file); }), HasSubstr(file.string()));
    EXPECT_THAT(message_of([&] { OutputFolder folder(file / "below"); }), HasSubstr(file.string()));
    EXPECT_THAT(message_of([&] { OutputFolder folder("/proc/gloam"); }), HasSubstr("/proc/gloam"));
}

}  // namespace gloam::report::output_test
