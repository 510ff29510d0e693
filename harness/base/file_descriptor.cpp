// SPDX-License-Identifier: MIT
#include "base/file_descriptor.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace gloam::base {

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    if (this != &other) {
        reset();
        number_ = other.release();
    }
    return *this;
}

void FileDescriptor::reset() {
    if (number_ >= 0) close(release());
}

FileDescriptor beyond_standard(FileDescriptor file) {
    if (file.get() < 0 || file.get() > STDERR_FILENO) return file;
    FileDescriptor higher(fcntl(file.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    if (!higher.is_open()) throw std::system_error(errno, std::generic_category(), "cannot move a file");
    return higher;
}

std::pair<FileDescriptor, FileDescriptor> connected_pair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot make a connection");
    FileDescriptor ours(ends[0]);
    FileDescriptor theirs(ends[1]);
    return {beyond_standard(std::move(ours)), beyond_standard(std::move(theirs))};
}

void reserve_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // Gets the lowest free number, which is this stream's. It is opened for the other direction, so
        // reading or writing fails.
        (void)!open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

}  // namespace gloam::base
