// SPDX-License-Identifier: MIT
#include "cli/read_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace gloam::cli {

std::string read_text(const std::filesystem::path& file) {
    std::error_code none;
    errno = std::filesystem::is_directory(file, none) ? EISDIR : 0;
    std::ifstream stream;
    if (errno == 0) stream.open(file, std::ios::binary);
    if (!stream.is_open())
        throw std::runtime_error(fmt::format("cannot read {}: {}", file.string(), std::strerror(errno)));
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace gloam::cli
