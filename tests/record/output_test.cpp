// SPDX-License-Identifier: MIT
#include "record/output.hpp"

#include "support/files.hpp"
#include "support/full_disk.hpp"

namespace gloam::record::output_test {

namespace fs = std::filesystem;

auto names(const fs::path& path) {
    return ThrowsMessage<std::runtime_error>(HasSubstr(path.string()));
}

using OutputFileTest = InFolder;

TEST_F(OutputFileTest, ReplacesAFileAsAWhole) {
    const fs::path path = folder.path() / "a.json";
    std::ofstream(path) << "something longer than what comes";
    const OutputFile file(path);
    EXPECT_EQ(test::read_file(path),
              "something longer than what comes");  // untouched until there is something to write
    file.write("new");
    EXPECT_EQ(test::read_file(path), "new");
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
}

// What a link leads to is replaced as a whole, too.
TEST_F(OutputFileTest, WhatALinkLeadsToIsNeverHalfWritten) {
    const fs::path target = folder.path() / "target";
    const fs::path link = folder.path() / "link";
    std::ofstream(target) << "precious";
    fs::create_symlink("target", link);
    const OutputFile file(link);
    {
        const test::FullDisk disk(1000);
        EXPECT_THAT([&] { file.write(std::string(5000, 'x')); }, names(target));
    }
    EXPECT_EQ(test::read_file(target), "precious");
}

TEST_F(OutputFileTest, OpenFilesAreWrittenTo) {
    const fs::path path = folder.path() / "a";
    std::FILE* open = std::fopen(path.c_str(), "w");
    OutputFile("/proc/self/fd/" + std::to_string(fileno(open))).write("text");
    std::fclose(open);
    EXPECT_EQ(test::read_file(path), "text");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST_F(OutputFileTest, AFolderThatCameInTheWayIsNamedAndNothingIsLeftBeside) {
    const fs::path path = folder.path() / "a.json";
    const OutputFile file(path);
    fs::create_directories(path / "below");
    EXPECT_THAT([&] { file.write("text"); }, names(path));
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
    EXPECT_TRUE(fs::exists(path / "below"));
}

using OutputFolderTest = InFolder;

TEST_F(OutputFolderTest, FilesAppearAndReplaceOthersWhenKept) {
    const fs::path out = folder.path() / "a" / "b";
    OutputFolder(out).write("x", "one");
    EXPECT_TRUE(fs::is_empty(folder.path()));
    fs::create_directories(out);
    std::ofstream(out / "x") << "old";
    OutputFolder output(out);
    output.write("x", "one");
    output.write("y", "two");
    EXPECT_EQ(test::read_file(out / "x"), "old");
    EXPECT_FALSE(fs::exists(out / "y"));
    output.keep();
    EXPECT_EQ(test::read_file(out / "x"), "one");
    EXPECT_EQ(test::read_file(out / "y"), "two");
}

TEST_F(OutputFolderTest, NoNameLeadsOutOfIt) {
    OutputFolder output(folder.path() / "out");
    for (const char* name : {"../x", "/x", "a/b", "..", ".", ""})
        EXPECT_THROW(output.write(name, "one"), std::invalid_argument) << name;
}

// Runs with one folder: each keeps its files all at once or not at all, and none fails for another.
TEST_F(OutputFolderTest, RunsWithOneFolderNeverMix) {
    const fs::path out = folder.path() / "out";
    for (int round = 0; round < 25; ++round) {
        std::vector<std::thread> runs;
        for (const char* text : {"a", "b", "c"}) {
            runs.emplace_back([&out, text] {
                EXPECT_NO_THROW({
                    OutputFolder folder(out);
                    for (const char* name : {"x", "y", "z", "w"}) folder.write(name, text);
                    folder.keep();
                });
            });
        }
        for (std::thread& run : runs) run.join();
        for (const char* name : {"y", "z", "w"})
            ASSERT_EQ(test::read_file(out / name), test::read_file(out / "x"));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 4);
}

}  // namespace gloam::record::output_test
