// SPDX-License-Identifier: MIT
#include "cli/read_text.hpp"

#include "base/read_file.hpp"

namespace gloam::cli {

std::string read_text(const std::filesystem::path& file) {
    return base::read_file(file);
}

}  // namespace gloam::cli
