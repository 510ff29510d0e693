// SPDX-License-Identifier: MIT
#include "base/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <random>
#include <stdexcept>
#include <utility>

#include "base/file_descriptor.hpp"

namespace gloam::base {
namespace {

namespace fs = std::filesystem;

// Not derived from `path`, because its name may already have the maximal length.
fs::path neighbour_of(const fs::path& path) {
    std::random_device entropy;
    return path.parent_path() / fmt::format(".gloam-{:08x}{:08x}.part", entropy(), entropy());
}

// Creates a file with an unpredictable name.
std::pair<fs::path, FileDescriptor> new_neighbour_of(const fs::path& path) {
    constexpr int attempts = 8;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        fs::path name = neighbour_of(path);
        FileDescriptor file(open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
        if (file.is_open()) return {std::move(name), beyond_standard(std::move(file))};
        if (errno != EEXIST) fail_to_write(path, errno);
    }
    fail_to_write(path, EEXIST);
}

}  // namespace

void fail_to_write(const fs::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

WrittenAside::WrittenAside(fs::path path, std::string_view bytes) : path_(std::move(path)) {
    auto [name, file] = new_neighbour_of(path_);
    int error = write_all(file.get(), bytes);
    // A full disk may be reported as late as here.
    const int number = dup(file.get());
    if (number < 0 || close(number) != 0) error = error == 0 ? errno : error;
    if (error != 0) {
        unlink(name.c_str());
        fail_to_write(path_, error);
    }
    aside_ = std::move(name);
}

WrittenAside::WrittenAside(WrittenAside&& other) noexcept
    : path_(std::move(other.path_)), aside_(std::exchange(other.aside_, {})) {}

WrittenAside::~WrittenAside() {
    if (!aside_.empty()) unlink(aside_.c_str());
}

void WrittenAside::put() {
    if (aside_.empty()) return;
    if (rename(aside_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
    aside_.clear();
}

void write_file(const fs::path& path, std::string_view bytes) {
    WrittenAside(path, bytes).put();
}

}  // namespace gloam::base
