// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gpu/image.hpp"

namespace gloam::cli {

// The two whole numbers of "640x360", or nothing where that is not what the text is.
[[nodiscard]] std::optional<gpu::Extent> extent_from(std::string_view text);

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

}  // namespace gloam::cli
