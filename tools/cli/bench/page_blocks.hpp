// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::cli {

// A part of a page that a command writes: what stands between the lines "<!-- begin NAME -->" and "<!-- end
// NAME -->".
struct PageBlock {
    std::string name;
    std::string text;  // whole lines
};

// The page with its blocks replaced; all else stays as it is. Throws std::invalid_argument that names the
// block when the page does not have its two lines, in this order, once each.
[[nodiscard]] std::string with_blocks(std::string page, const std::vector<PageBlock>& blocks);

// The page in a file, as it is. Throws std::runtime_error that names the file when it cannot be read.
[[nodiscard]] std::string read_page(const std::filesystem::path& file);

}  // namespace gloam::cli
