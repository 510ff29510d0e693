// SPDX-License-Identifier: MIT
#include "report/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/files.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;
using base::fail_to_write;

// Names can come from data, and must not lead out of the folder.
void require_file_name(const std::string& name) {
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
        name.find('\0') != std::string::npos)
        throw std::invalid_argument("output file \"" + name + "\": expected a name without a folder");
}

// Locks the folder for this process until the end of the scope.
class FolderLock {
  public:
    explicit FolderLock(const fs::path& folder)
        : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (!file_.is_open()) return;  // put() reports the reason
        while (flock(file_.get(), LOCK_EX) != 0 && errno == EINTR) {
        }
    }

  private:
    base::FileDescriptor file_;
};

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
        fail_to_write(folder_, error.value());
    }
    if (!fs::is_directory(folder_, error)) fail_to_write(folder_, ENOTDIR);
    if (access(folder_.c_str(), W_OK | X_OK) != 0) fail_to_write(folder_, errno);
}

OutputFolder::~OutputFolder() {
    waiting_.clear();
    std::error_code ignored;  // a destructor cannot report it
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    require_file_name(name);
    const fs::path file = folder_ / name;
    std::error_code none;
    if (fs::is_directory(file, none)) fail_to_write(file, EISDIR);
    fs::create_directories(folder_, none);  // another run that had made it may have removed it
    base::WrittenAside aside(file, bytes);
    const auto known =
        std::ranges::find(waiting_, file, [](const base::WrittenAside& other) { return other.path(); });
    if (known != waiting_.end()) waiting_.erase(known);
    waiting_.push_back(std::move(aside));
}

void OutputFolder::keep() {
    made_.clear();
    const FolderLock lock(folder_);
    while (!waiting_.empty()) {
        waiting_.front().put();
        waiting_.pop_front();
    }
}

}  // namespace gloam::report
