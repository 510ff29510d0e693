// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

namespace gloam::base {

// An open file; the destructor closes it.
class FileDescriptor {
  public:
    explicit FileDescriptor(int number = -1) : number_(number) {}
    ~FileDescriptor() { reset(); }
    FileDescriptor(FileDescriptor&& other) noexcept : number_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] int get() const { return number_; }
    [[nodiscard]] bool is_open() const { return number_ >= 0; }
    void reset();

  private:
    int release() { return std::exchange(number_, -1); }
    int number_;
};

// The same open file with a number above those of the standard streams, which a child's dup2() would
// overwrite; closed by exec.
[[nodiscard]] FileDescriptor beyond_standard(FileDescriptor file);

// Two ends of a connection, each beyond_standard(). They are sockets and not a pipe, so that writing to a
// program that has ended is an error and not a signal. Throws std::system_error.
[[nodiscard]] std::pair<FileDescriptor, FileDescriptor> connected_pair();

// Opens each closed standard stream so that every use of it fails, and no other file gets its number. Call it
// before anything else is opened.
void reserve_standard_streams();

}  // namespace gloam::base
