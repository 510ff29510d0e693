// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "base/write_file.hpp"

namespace gloam::report {

// A folder that receives the files of one run: all of them, or none. Files appear under their names when
// keep() is called; until then they lie beside under names that nobody else uses, and go with the object, as
// do folders that it made itself. Of several runs with one folder each keeps all of its files at once.
class OutputFolder {
  public:
    // Makes the folder where it is missing. Throws std::runtime_error that names it when it cannot be made or
    // written to: found out before the work, not after.
    explicit OutputFolder(std::filesystem::path folder);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    // Writes a file, replacing one of the same name at keep(), be it a link. Throws std::runtime_error that
    // names the file and the reason (a full disk, say), std::invalid_argument for a name that is a path.
    void write(const std::string& name, std::string_view bytes);

    // All files get their names. Throws std::runtime_error that names the file that could not.
    void keep();

  private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> made_;  // folders, outermost first
    std::list<base::WrittenAside> waiting_;
};

}  // namespace gloam::report
