// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "report/internal/write.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;

// Devices (/dev/full) and links (/dev/stdout) are written to as they are; files by way of a neighbour, so
// that nobody sees half of one.
bool is_written_in_place(const fs::path& path) {
    std::error_code none;
    const fs::file_status status = fs::symlink_status(path, none);
    return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code none;
    if (fs::is_directory(path_, none)) internal::fail_to_write(path_, EISDIR);
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (access(folder.c_str(), W_OK) != 0) internal::fail_to_write(path_, errno);
}

void OutputFile::write(std::string_view text) const {
    if (path_.empty()) return;
    const bool direct = is_written_in_place(path_);
    const fs::path target = direct ? path_ : internal::part_of(path_);
    int error = internal::write_all(target, text);
    std::error_code moved;
    if (error == 0 && !direct) {
        fs::rename(target, path_, moved);
        error = moved.value();
    }
    if (error == 0) return;
    if (!direct) fs::remove(target, moved);
    internal::fail_to_write(path_, error);
}

}  // namespace gloam::report
