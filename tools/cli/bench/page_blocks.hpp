// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::cli {

// A part of a page that a command generates: the text between the lines "<!-- begin NAME -->" and "<!-- end
// NAME -->".
struct PageBlock {
    std::string name;
    std::string text;  // whole lines
};

// The page with its blocks replaced. Throws std::invalid_argument with the block's name unless the page
// contains its two lines, in this order, exactly once.
[[nodiscard]] std::string with_blocks(std::string page, const std::vector<PageBlock>& blocks);

// Reads the page unchanged. Throws std::runtime_error with the file's name if it cannot be read.
[[nodiscard]] std::string read_page(const std::filesystem::path& file);

}  // namespace gloam::cli
