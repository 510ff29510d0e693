// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace gloam::base {

// Throws std::runtime_error: "cannot write PATH: REASON", the reason of that error number.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

// Writes all bytes to an open file. Returns 0, or the error number of what went wrong.
[[nodiscard]] int write_all(int file, std::string_view bytes);

// Bytes that are to become a file. They lie beside it, whole, in a file of a name that nobody else uses,
// until put() gives them the file's name; without it they go with the object.
class WrittenAside {
  public:
    // Throws std::runtime_error that names `path` and why it cannot be written (a full disk, say); nothing is
    // left behind then.
    WrittenAside(std::filesystem::path path, std::string_view bytes);
    ~WrittenAside();
    WrittenAside(WrittenAside&& other) noexcept;
    WrittenAside& operator=(WrittenAside&&) = delete;
    WrittenAside(const WrittenAside&) = delete;
    WrittenAside& operator=(const WrittenAside&) = delete;

    // Replaces the file of that name, which may be a link: the link is replaced, not followed. Throws
    // std::runtime_error.
    void put();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::filesystem::path aside_;  // empty: put, or moved from
};

// Makes or replaces a file as a whole: nobody sees half of it, not even when two write it at once. Throws
// std::runtime_error.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gloam::base
