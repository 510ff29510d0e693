// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace gloam::base {
namespace file_descriptor_test {

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

}  // namespace file_descriptor_test
}  // namespace gloam::base
