// SPDX-License-Identifier: MIT
#include "base/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "base/file_descriptor.hpp"

namespace gloam::base {

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

}  // namespace gloam::base
