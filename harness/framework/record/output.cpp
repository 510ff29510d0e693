// SPDX-License-Identifier: MIT
#include "record/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/files.hpp"
#include "base/text.hpp"

namespace gloam::record {

namespace {

namespace fs = std::filesystem;
using base::fail_to_write;

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

// named: in the message of an error.
void write_in_place(const fs::path& path, std::string_view text, const fs::path& named) {
    base::FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (!file.is_open()) fail_to_write(named, errno);
    if (const int error = base::write_all(std::move(file), text)) fail_to_write(named, error);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code none;
    if (fs::is_directory(path_, none)) fail_to_write(path_, EISDIR);
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (is_written_in_place(path_)) return;
    if (access(folder.c_str(), W_OK) != 0) fail_to_write(path_, errno);
}

void OutputFile::write(std::string_view text) const {
    if (path_.empty()) return;
    if (is_written_in_place(path_)) {
        write_in_place(path_, text, path_);
    } else {
        base::write_file(end_of_links(path_), text);
    }
}

OutputFolder::OutputFolder(fs::path folder)
    : folder_(folder.empty() ? fs::path(".") : std::move(folder)),
      waiting_(base::TemporaryFolder::in(folder_)) {}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    // Names can come from data, and must not lead out of the folder.
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
        name.find('\0') != std::string::npos)
        throw std::invalid_argument("output file \"" + name + "\": expected a name without a folder");
    const fs::path file = folder_ / name;
    std::error_code none;
    if (fs::is_directory(file, none)) fail_to_write(file, EISDIR);
    names_.insert(name);
    write_in_place(waiting_.path() / name, bytes, file);
}

void OutputFolder::keep() {
    // Other runs wait until this one's files are there. Where it cannot be locked, rename() tells why.
    const base::FileDescriptor lock(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    while (lock.is_open() && flock(lock.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
    for (const std::string& name : names_)
        if (rename((waiting_.path() / name).c_str(), (folder_ / name).c_str()) != 0)
            fail_to_write(folder_ / name, errno);
    names_.clear();
}

void take_lines(const std::string& name, std::string_view text, const TakeLine& take, char end) {
    std::size_t number = 0;
    try {
        do {
            ++number;
            const std::size_t length = std::min(text.find(end), text.size());
            take(text.substr(0, length));
            text.remove_prefix(std::min(length + 1, text.size()));
        } while (!text.empty());
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}, line {}: {}", name, number, error.what()));
    }
}

Journal::Journal(fs::path path, const std::string& heading, bool resume, const TakeLine& take)
    : path_(std::move(path)) {
    constexpr std::size_t longest = std::size_t{1} << 30;  // bytes
    constexpr std::size_t longest_quote = 300;
    if (path_.empty()) return;
    std::string kept;
    if (resume && fs::exists(path_)) kept = base::read_file(path_, longest);
    kept.erase(kept.rfind('\n') + 1);
    if (kept.empty()) kept = heading + "\n";
    const std::string found = kept.substr(0, kept.find('\n'));
    if (found != heading)
        throw std::runtime_error(
            fmt::format("{}: cannot resume what was measured otherwise: expected {}, found {}",
                        path_.string(), heading, base::shortened(found, longest_quote)));
    take_lines(path_.string(), kept, [&, first = true](std::string_view line) mutable {
        if (!std::exchange(first, false)) take(line);
    });
    base::write_file(path_, kept);
}

void Journal::add(std::string_view line) const {
    if (path_.empty()) return;
    base::FileDescriptor file(open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW));
    if (!file.is_open()) fail_to_write(path_, errno);
    const std::string text = std::string(line) + "\n";
    if (const int error = base::write_all(std::move(file), text)) fail_to_write(path_, error);
}

}  // namespace gloam::record
