// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "base/files.hpp"

namespace gloam::record {

// A file that is written at the end of long work; the constructor finds out whether it can be. It appears
// complete or not at all. A link remains, and its target is replaced. Devices and open files (/dev/stdout)
// are written in place. An empty path writes nothing.
class OutputFile {
  public:
    // Throws std::runtime_error if the folder is missing or cannot be written to.
    explicit OutputFile(std::filesystem::path path);

    // Writes the file. Throws std::runtime_error if that fails (a full disk, say), and leaves nothing behind.
    void write(std::string_view text) const;

  private:
    std::filesystem::path path_;
};

// A folder that receives the files of one run: all of them, or none. They come into it when keep() is called.
// Until then they are in a hidden folder below it, which is removed with the object, as are folders that it
// created and that are empty. If several runs use one folder, each keeps all of its files at once.
class OutputFolder {
  public:
    // Creates the folder if it is missing. Throws std::runtime_error with its name if it cannot be created or
    // written to, before any work.
    explicit OutputFolder(std::filesystem::path folder);

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    // Writes a file. keep() replaces a file or link of the same name. Throws std::runtime_error with the
    // file's name and the reason, for example a full disk; std::invalid_argument for a name that is a path.
    void write(const std::string& name, std::string_view bytes);

    // Gives all files their names. Throws std::runtime_error with the name of a file for which this fails.
    void keep();

  private:
    std::filesystem::path folder_;
    base::TemporaryFolder waiting_;
    std::set<std::string> names_;  // of the files in it
};

// Gives `take` each line of a text. The std::runtime_error that it throws gets "NAME, line 3: " before it.
using TakeLine = std::function<void(std::string_view line)>;
void take_lines(const std::string& name, std::string_view text, const TakeLine& take, char end = '\n');

// A file of rows, a line of JSON each, that is written as they come, so that an interruption loses none of
// them. Its first line states the conditions under which the others may be taken over.
class Journal {
  public:
    // Starts the file anew, or, with `resume`, gives `take` its lines if it begins with `heading`. A last
    // line without its end was being written, and is dropped. An empty path: no file. Throws like
    // take_lines(), and std::runtime_error for a file that cannot be read or written or has another heading.
    Journal(std::filesystem::path path, const std::string& heading, bool resume, const TakeLine& take);

    // Appends a line (without its end); on return it is in the file, or std::runtime_error is thrown.
    void add(std::string_view line) const;

  private:
    std::filesystem::path path_;
};

}  // namespace gloam::record
