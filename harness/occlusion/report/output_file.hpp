// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace gloam::report {

// A file that is written at the end of long work; the constructor finds out whether it can be. It appears
// complete or not at all. A link remains, and its target is replaced. Devices and open files (/dev/stdout)
// are written in place. An empty path writes nothing.
class OutputFile {
  public:
    // Throws std::runtime_error if the folder is missing or cannot be written to.
    explicit OutputFile(std::filesystem::path path);

    // Writes the file. Throws std::runtime_error if that fails, for example on a full disk; then nothing is
    // left behind.
    void write(std::string_view text) const;

  private:
    std::filesystem::path path_;
};

}  // namespace gloam::report
