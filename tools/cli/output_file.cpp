// SPDX-License-Identifier: MIT
#include "cli/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

bool is_device(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none) && !fs::is_regular_file(path, none);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code none;
    if (fs::is_directory(path_, none)) fail(path_, EISDIR);
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (access(folder.c_str(), W_OK) != 0) fail(path_, errno);
}

void OutputFile::write(std::string_view text) const {
    if (path_.empty()) return;
    // Devices (/dev/stdout) are written to as they are; files by way of a neighbour, so that nobody sees half
    // of one.
    const bool direct = is_device(path_);
    const fs::path target = direct ? path_ : fs::path(path_.string() + ".part");
    errno = 0;
    std::ofstream stream(target, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
        const int error = errno != 0 ? errno : EIO;
        std::error_code none;
        if (!direct) fs::remove(target, none);
        fail(path_, error);
    }
    if (!direct) fs::rename(target, path_);
}

}  // namespace gloam::cli
