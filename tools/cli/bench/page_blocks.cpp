// SPDX-License-Identifier: MIT
#include "cli/bench/page_blocks.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gloam::cli {
namespace {

// The position of a line that must occur exactly once.
std::size_t line_in(const std::string& page, const std::string& line) {
    const std::size_t at = page.find(line);
    if (at == std::string::npos || page.find(line, at + 1) != std::string::npos)
        throw std::invalid_argument(fmt::format("the page: expected one line \"{}\"", line));
    return at;
}

}  // namespace

std::string with_blocks(std::string page, const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) {
        const std::string begin = fmt::format("<!-- begin {} -->\n", block.name);
        const std::string end = fmt::format("<!-- end {} -->", block.name);
        const std::size_t first = line_in(page, begin) + begin.size();
        const std::size_t last = line_in(page, end);
        if (last < first)
            throw std::invalid_argument(fmt::format("the page: block {} ends before it begins", block.name));
        page.replace(first, last - first, "\n" + block.text + "\n");
    }
    return page;
}

std::string read_page(const std::filesystem::path& file) {
    std::ostringstream text;
    const std::ifstream stream(file);
    if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
    text << stream.rdbuf();
    return text.str();
}

}  // namespace gloam::cli
