// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"

namespace gloam::report {

// A folder that receives the files of one run: all of them, or none. Files get their names when keep() is
// called. Until then they have unique temporary names beside these, and are removed with the object, as are
// folders that it created. If several runs use one folder, each keeps all of its files at once.
class OutputFolder {
  public:
    // Creates the folder if it is missing. Throws std::runtime_error with its name if it cannot be created or
    // written to, before any work.
    explicit OutputFolder(std::filesystem::path folder);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    // Writes a file. keep() replaces a file or link of the same name. Throws std::runtime_error with the
    // file's name and the reason, for example a full disk; std::invalid_argument for a name that is a path.
    void write(const std::string& name, std::string_view bytes);

    // Gives all files their names. Throws std::runtime_error with the name of a file for which this fails.
    void keep();

  private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> made_;  // folders, outermost first
    std::list<base::WrittenAside> waiting_;
};

}  // namespace gloam::report
