// SPDX-License-Identifier: MIT
#include "report/output_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "report/internal/write.hpp"

namespace gloam::report {

namespace fs = std::filesystem;
using internal::fail_to_write;
using internal::part_of;

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
        fail_to_write(folder_, error.value());
    }
    if (!fs::is_directory(folder_, error)) fail_to_write(folder_, ENOTDIR);
    if (access(folder_.c_str(), W_OK | X_OK) != 0) fail_to_write(folder_, errno);
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;  // a destructor has nobody to tell
    for (const std::string& name : waiting_) fs::remove(part_of(folder_ / name), ignored);
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    const fs::path file = folder_ / name;
    std::error_code none;
    if (fs::is_directory(file, none)) fail_to_write(file, EISDIR);
    if (std::ranges::find(waiting_, name) == waiting_.end()) waiting_.push_back(name);
    if (const int error = internal::write_all(part_of(file), bytes)) fail_to_write(file, error);
}

void OutputFolder::keep() {
    made_.clear();
    while (!waiting_.empty()) {
        const fs::path file = folder_ / waiting_.front();
        std::error_code error;
        fs::rename(part_of(file), file, error);
        if (error) fail_to_write(file, error.value());
        waiting_.erase(waiting_.begin());
    }
}

}  // namespace gloam::report
