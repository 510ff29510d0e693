// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/files.hpp"
#include "support/full_disk.hpp"
#include "support/run_command.hpp"

namespace gloam::base {
namespace write_file_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::size_t count_files(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(WriteFile, MakesAndReplaces) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a";
    write_file(path, "something long");
    EXPECT_EQ(test::read_file(path), "something long");
    write_file(path, "new");
    EXPECT_EQ(test::read_file(path), "new");
    EXPECT_EQ(count_files(scratch.path()), 1U);
}

TEST(WriteFile, TheFileIsAsItWasUntilPut) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a";
    write_file(path, "old");
    {
        const WrittenAside aside(path, "new");
        EXPECT_EQ(test::read_file(path), "old");
        EXPECT_EQ(count_files(scratch.path()), 2U);
    }
    EXPECT_EQ(test::read_file(path), "old");
    EXPECT_EQ(count_files(scratch.path()), 1U);
}

TEST(WriteFile, ALinkIsReplacedAndNotFollowed) {
    const test::TemporaryDirectory scratch;
    const fs::path victim = scratch.path() / "victim";
    const fs::path path = scratch.path() / "a";
    write_file(victim, "precious");
    fs::create_symlink(victim, path);
    fs::create_symlink(victim, scratch.path() / "a.part");  // a name that once was used
    write_file(path, "new");
    EXPECT_EQ(test::read_file(victim), "precious");
    EXPECT_FALSE(fs::is_symlink(path));
    EXPECT_EQ(test::read_file(path), "new");
}

TEST(WriteFile, AFullDiskIsNamedAndLeavesNothing) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a";
    const test::FullDisk disk(1000);
    EXPECT_THAT(
        [&] { write_file(path, std::string(5000, 'x')); },
        ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(path.string()), HasSubstr("File too large"))));
    EXPECT_EQ(count_files(scratch.path()), 0U);
}

TEST(WriteFile, AMissingFolderIsNamed) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "none" / "a";
    EXPECT_THAT([&] { write_file(path, "x"); }, ThrowsMessage<std::runtime_error>(AllOf(
                                                    HasSubstr(path.string()), HasSubstr("No such file"))));
}

TEST(WriteFile, NamesAsLongAsNamesCanBe) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / std::string(255, 'n');
    write_file(path, "x");
    EXPECT_EQ(test::read_file(path), "x");
}

// Each write is whole, whoever comes last.
TEST(WriteFile, ManyAtOnceNeverMixAndNeverFail) {
    const test::TemporaryDirectory scratch;
    const fs::path path = scratch.path() / "a";
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
    EXPECT_EQ(count_files(scratch.path()), 1U);
}

}  // namespace write_file_test
}  // namespace gloam::base
