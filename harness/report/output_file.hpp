// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace gloam::report {

// A file to be written at the end of long work: whether it can be is found out at the beginning. It appears
// whole or not at all; a link that the caller names stays one, and what it leads to is replaced. Devices and
// open files (/dev/stdout) are written to. An empty path writes nothing.
class OutputFile {
  public:
    // Throws std::runtime_error when the folder is missing or cannot be written to.
    explicit OutputFile(std::filesystem::path path);

    // Throws std::runtime_error when the text could not be written (a full disk, say); nothing is left behind
    // then.
    void write(std::string_view text) const;

  private:
    std::filesystem::path path_;
};

}  // namespace gloam::report
