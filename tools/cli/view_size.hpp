// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gpu/image.hpp"

namespace gloam::cli {

// The two integers of "640x360"; nullopt for other text.
[[nodiscard]] std::optional<gpu::Extent> extent_from(std::string_view text);

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

}  // namespace gloam::cli
