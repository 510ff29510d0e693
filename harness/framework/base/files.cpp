// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <random>
#include <stdexcept>
#include <system_error>

namespace gloam::base {

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

void FileDescriptor::reset() {
    if (number_ >= 0) close(release());
}

FileDescriptor beyond_standard(FileDescriptor file) {
    if (file.get() < 0 || file.get() > STDERR_FILENO) return file;
    FileDescriptor higher(fcntl(file.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    if (!higher.is_open()) throw std::system_error(errno, std::generic_category(), "cannot move a file");
    return higher;
}

std::pair<FileDescriptor, FileDescriptor> connected_pair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot make a connection");
    FileDescriptor ours(ends[0]);
    FileDescriptor theirs(ends[1]);
    return {beyond_standard(std::move(ours)), beyond_standard(std::move(theirs))};
}

void reserve_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // Gets the lowest free number, which is this stream's. It is opened for the other direction, so
        // reading or writing fails.
        (void)!open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

std::string read_file(const std::filesystem::path& path, std::size_t largest) {
    const auto fail = [&path](const std::string& why) {
        throw std::runtime_error(fmt::format("cannot read {}: {}", path.string(), why));
    };
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) fail(std::strerror(errno));
    std::string text;
    while (text.size() <= largest) {
        constexpr std::size_t block = 1U << 16U;
        const std::size_t had = text.size();
        text.resize(had + std::min(block, largest + 1 - had));
        const ssize_t count = read(file.get(), text.data() + had, text.size() - had);
        text.resize(had + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count < 0 && errno != EINTR) fail(std::strerror(errno));
        if (count == 0) return text;
    }
    fail(fmt::format("it is longer than {} bytes", largest));
    return text;
}

namespace {

namespace fs = std::filesystem;

// A word that no name had before.
std::string new_word() {
    std::random_device entropy;
    return fmt::format("{:08x}{:08x}", entropy(), entropy());
}

// A folder, and those around it that are missing.
std::vector<fs::path> with_missing(fs::path folder) {
    std::vector<fs::path> all{std::move(folder)};
    std::error_code none;
    for (fs::path around = all[0].parent_path(); !around.empty() && !fs::exists(around, none);
         around = around.parent_path())
        all.push_back(around);
    return all;
}

// Returns 0, or the error number.
int make_folder(const fs::path& path) {
    constexpr int attempts = 100;  // another process that made the parent may remove it between the two steps
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (!error && mkdir(path.c_str(), S_IRWXU) == 0) return 0;
        const int reason = error ? error.value() : errno;
        if (reason != ENOENT) return reason;
    }
    return ENOENT;
}

}  // namespace

void fail_to_write(const fs::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

int write_all(FileDescriptor file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file.get(), bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return errno;
        }
    }
    // A full disk may be reported as late as here.
    const int number = dup(file.get());
    return number >= 0 && close(number) == 0 ? 0 : errno;
}

void write_file(const fs::path& path, std::string_view bytes) {
    // Not derived from the name of `path`, which may already have the maximal length.
    const fs::path name = path.parent_path() / fmt::format(".gloam-{}.part", new_word());
    FileDescriptor file(open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file.is_open()) fail_to_write(path, errno);
    int error = write_all(beyond_standard(std::move(file)), bytes);
    if (error == 0 && rename(name.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return;
    unlink(name.c_str());
    fail_to_write(path, error);
}

TemporaryFolder::TemporaryFolder(std::string_view purpose)
    : TemporaryFolder(
          std::vector{fs::temp_directory_path() / fmt::format("gloam-{}-{}", purpose, new_word())}) {}

TemporaryFolder TemporaryFolder::in(const fs::path& parent) {
    return TemporaryFolder(with_missing(parent / (".gloam-part-" + new_word())));
}

TemporaryFolder::TemporaryFolder(std::vector<fs::path> made) : made_(std::move(made)) {
    if (const int error = make_folder(path())) {
        remove();
        fail_to_write(path().parent_path(), error);
    }
}

TemporaryFolder::~TemporaryFolder() {
    remove();
}

void TemporaryFolder::remove() {
    std::error_code ignored;
    fs::remove_all(path(), ignored);
    for (const fs::path& folder : made_) rmdir(folder.c_str());
}

}  // namespace gloam::base
