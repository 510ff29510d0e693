// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

constexpr std::size_t largest_text = std::size_t{64} << 20;  // bytes

// The content of a file. Throws std::runtime_error with its name and the reason: it cannot be read, is a
// folder, or has more than `largest` bytes (for example an endless device).
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t largest = largest_text);

// Throws std::runtime_error: "cannot write PATH: REASON", with the reason of this error number.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

// Writes all bytes to an open file and closes it. Returns 0, or the error number.
[[nodiscard]] int write_all(FileDescriptor file, std::string_view bytes);

// A new empty folder for files of this process. It is removed with the object, and all that it holds; a
// process that is killed leaves it.
class TemporaryFolder {
  public:
    // `purpose`: a part of its name. Throws std::runtime_error that names the parent.
    explicit TemporaryFolder(std::string_view purpose);
    // In another folder, with a hidden name. Creates that folder if it is missing, and those around it; they
    // are removed as well, as far as they are empty then.
    static TemporaryFolder in(const std::filesystem::path& parent);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return made_.front(); }

  private:
    explicit TemporaryFolder(std::vector<std::filesystem::path> made);
    void remove();

    std::vector<std::filesystem::path> made_;  // it, and the folders around it, the innermost first
};

// Creates or replaces a file atomically: no reader sees a part of it, not even when two processes write it at
// once. Throws std::runtime_error.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gloam::base
