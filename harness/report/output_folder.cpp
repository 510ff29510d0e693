// SPDX-License-Identifier: MIT
#include "report/output_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace gloam::report {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

// Writes all or returns the error number; a full disk may show as late as in close().
int write_all(const fs::path& path, std::string_view bytes) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    int error = 0;
    while (!bytes.empty() && error == 0) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    if (close(file) != 0 && error == 0) error = errno;
    return error;
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
    if (folder_.empty()) folder_ = ".";
    std::error_code error;
    for (fs::path missing = folder_; !missing.empty() && !fs::exists(missing, error);
         missing = missing.parent_path()) {
        made_.insert(made_.begin(), missing);
    }
    for (std::size_t i = 0; i < made_.size(); ++i) {
        fs::create_directory(made_[i], error);
        if (!error) continue;
        for (std::size_t j = i; j-- > 0;) {
            std::error_code ignored;
            fs::remove(made_[j], ignored);
        }
        fail(folder_, error.value());
    }
    if (!fs::is_directory(folder_, error)) fail(folder_, ENOTDIR);
    if (access(folder_.c_str(), W_OK | X_OK) != 0) fail(folder_, errno);
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;  // a destructor has nobody to tell
    for (const std::string& name : waiting_) fs::remove(folder_ / (name + ".part"), ignored);
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    const fs::path file = folder_ / name;
    std::error_code none;
    if (fs::is_directory(file, none)) fail(file, EISDIR);
    if (std::ranges::find(waiting_, name) == waiting_.end()) waiting_.push_back(name);
    if (const int error = write_all(folder_ / (name + ".part"), bytes)) fail(file, error);
}

void OutputFolder::keep() {
    made_.clear();
    while (!waiting_.empty()) {
        const fs::path file = folder_ / waiting_.front();
        std::error_code error;
        fs::rename(file.string() + ".part", file, error);
        if (error) fail(file, error.value());
        waiting_.erase(waiting_.begin());
    }
}

}  // namespace gloam::report
