// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace gloam::cli {

// One of `count` equal shares of a list: every element whose position modulo `count` is `index`.
struct Shard {
    std::size_t index = 0;  // counts from 0, below count
    std::size_t count = 1;

    [[nodiscard]] bool holds(std::size_t position) const { return position % count == index; }
};

// Parses "INDEX/COUNT". For an empty text it uses the variables of GoogleTest and ctest: $GTEST_SHARD_INDEX
// of $GTEST_TOTAL_SHARDS, or everything if they are not set. Throws std::invalid_argument with the error.
[[nodiscard]] Shard shard_from(const std::string& text);

}  // namespace gloam::cli
