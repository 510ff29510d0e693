// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/files.hpp"
#include "support/files.hpp"
#include "support/full_disk.hpp"
#include "support/run_command.hpp"

namespace gloam::base {

namespace files_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

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
    EXPECT_THAT([&] { (void)read_file(scratch.path() / "none"); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("none"), HasSubstr("No such file"))));
    EXPECT_THAT([&] { (void)read_file(scratch.path()); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(scratch.path().string()), HasSubstr("Is a directory"))));
}

TEST(ReadFile, ADeviceWithoutEndIsTooLong) {
    EXPECT_THAT([] { (void)read_file("/dev/zero", 100'000); },
                ThrowsMessage<std::runtime_error>(HasSubstr("/dev/zero: it is longer than 100000 bytes")));
}

namespace fs = std::filesystem;

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

TEST(FileDescriptor, ClosesAtItsEnd) {
    int number = -1;
    {
        const FileDescriptor file(open("/dev/null", O_RDONLY | O_CLOEXEC));
        number = file.get();
        EXPECT_TRUE(file.is_open());
    }
    EXPECT_EQ(fcntl(number, F_GETFD), -1);
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

}  // namespace files_test

}  // namespace gloam::base
