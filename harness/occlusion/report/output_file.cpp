// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/files.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;

// The target of a link; the link itself if its target does not exist.
fs::path end_of_links(const fs::path& path) {
    std::error_code none;
    if (!fs::is_symlink(path, none)) return path;
    fs::path end = fs::weakly_canonical(path, none);
    return none || end.empty() ? path : end;
}

// Devices (/dev/full) and files that this process has open (/dev/stdout) are written in place.
bool is_written_in_place(const fs::path& path) {
    std::error_code none;
    const fs::file_status status = fs::status(path, none);
    if (fs::exists(status) && !fs::is_regular_file(status)) return true;
    fs::path link = path;
    constexpr int most_links = 40;
    for (int i = 0; i < most_links && fs::is_symlink(link, none); ++i) {
        const fs::path folder = fs::canonical(link.has_parent_path() ? link.parent_path() : ".", none);
        if (folder.string().starts_with("/proc/")) return true;
        link = folder / fs::read_symlink(link, none);
    }
    return false;
}

void write_in_place(const fs::path& path, std::string_view text) {
    const base::FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (!file.is_open()) base::fail_to_write(path, errno);
    if (const int error = base::write_all(file.get(), text)) base::fail_to_write(path, error);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code none;
    if (fs::is_directory(path_, none)) base::fail_to_write(path_, EISDIR);
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (access(folder.c_str(), W_OK) != 0) base::fail_to_write(path_, errno);
}

void OutputFile::write(std::string_view text) const {
    if (path_.empty()) return;
    if (is_written_in_place(path_)) {
        write_in_place(path_, text);
    } else {
        base::write_file(end_of_links(path_), text);
    }
}

}  // namespace gloam::report
