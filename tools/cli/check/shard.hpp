// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace gloam::cli {

// One of `count` equal shares of a list: every element whose position leaves the remainder `index`.
struct Shard {
    std::size_t index = 0;  // counts from 0, below count
    std::size_t count = 1;

    [[nodiscard]] bool holds(std::size_t position) const { return position % count == index; }
};

// "INDEX/COUNT", or for an empty text what GoogleTest and ctest say: $GTEST_SHARD_INDEX of
// $GTEST_TOTAL_SHARDS, all when they are not set. Throws std::invalid_argument that names what is wrong.
[[nodiscard]] Shard shard_from(const std::string& text);

}  // namespace gloam::cli
