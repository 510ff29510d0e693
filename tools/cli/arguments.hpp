// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "backend/vulkan/resources.hpp"

namespace gloam::cli {

// All of a file, of at most base::largest_text bytes. Throws std::runtime_error that names it and says why it
// cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The two whole numbers of a text such as "640x360", with this character between them; nothing for other
// text.
[[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> pair_from(std::string_view text,
                                                                               char between);

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

// The value of --size for images that are judged: each side 16 to 4096 pixels, so that a kernel, a window and
// a pixel's neighbours fit.
[[nodiscard]] gpu::Extent judged_size(const std::string& text);

}  // namespace gloam::cli
