// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace gloam::base {

// Throws std::runtime_error: "cannot write PATH: REASON", with the reason of this error number.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

// Writes all bytes to an open file. Returns 0, or the error number.
[[nodiscard]] int write_all(int file, std::string_view bytes);

// The future content of a file, written completely to a file of a unique name beside it. put() renames it;
// otherwise it is removed with the object.
class WrittenAside {
  public:
    // Throws std::runtime_error with `path` and the reason why it cannot be written, for example a full disk;
    // then nothing is left behind.
    WrittenAside(std::filesystem::path path, std::string_view bytes);
    ~WrittenAside();
    WrittenAside(WrittenAside&& other) noexcept;
    WrittenAside& operator=(WrittenAside&&) = delete;
    WrittenAside(const WrittenAside&) = delete;
    WrittenAside& operator=(const WrittenAside&) = delete;

    // Replaces the file of that name. A link is replaced, not followed. Throws std::runtime_error.
    void put();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::filesystem::path aside_;  // empty: put, or moved from
};

// Creates or replaces a file atomically: no reader sees a part of it, not even when two processes write it at
// once. Throws std::runtime_error.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gloam::base
