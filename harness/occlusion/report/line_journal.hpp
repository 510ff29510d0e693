// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::report {

// A file of lines that is written as results come, so that an interruption loses none of them. Its first line
// states the conditions under which the other lines may be taken over.
class LineJournal {
  public:
    // Starts the file anew, or, with `resume`, takes over its lines if it begins with `heading`. A last line
    // without its end was being written, and is dropped. An empty path: no file. Throws std::runtime_error
    // for a file that cannot be read or written, or that begins with another heading.
    LineJournal(std::filesystem::path path, const std::string& heading, bool resume);

    // The lines that were taken over, without the heading; the first of them is line 2 of the file.
    [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    // Appends a line (without its end); on return it is in the file. Throws std::runtime_error if it cannot
    // be written.
    void add(std::string_view line) const;

  private:
    void take_over(std::string_view text, const std::string& heading);

    std::filesystem::path path_;
    std::vector<std::string> lines_;
};

}  // namespace gloam::report
