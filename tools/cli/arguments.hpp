// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gpu/resources.hpp"

namespace gloam::cli {

// All of a file, of at most base::largest_text bytes. Throws std::runtime_error that names it and says why it
// cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The two integers of "640x360"; nullopt for other text.
[[nodiscard]] std::optional<gpu::Extent> extent_from(std::string_view text);

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

}  // namespace gloam::cli
