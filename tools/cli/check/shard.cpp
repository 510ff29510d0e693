// SPDX-License-Identifier: MIT
#include "cli/check/shard.hpp"

#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace gloam::cli {
namespace {

constexpr const char* index_variable = "GTEST_SHARD_INDEX";
constexpr const char* count_variable = "GTEST_TOTAL_SHARDS";

bool read_number(std::string_view text, std::size_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

Shard shard_of(std::string_view index, std::string_view count, const std::string& where) {
    Shard shard;
    if (!read_number(index, shard.index) || !read_number(count, shard.count) || shard.index >= shard.count) {
        throw std::invalid_argument(where + ": expected INDEX/COUNT with 0 <= INDEX < COUNT, found " +
                                    std::string(index) + "/" + std::string(count));
    }
    return shard;
}

}  // namespace

Shard shard_from(const std::string& text) {
    if (!text.empty()) {
        const std::size_t slash = text.find('/');
        const std::string_view all = text;
        if (slash == std::string::npos) return shard_of(all, "", "--shard");
        return shard_of(all.substr(0, slash), all.substr(slash + 1), "--shard");
    }
    const char* index = std::getenv(index_variable);
    const char* count = std::getenv(count_variable);
    if (index == nullptr && count == nullptr) return {};
    return shard_of(index == nullptr ? "" : index, count == nullptr ? "" : count,
                    std::string(index_variable) + " and " + count_variable);
}

}  // namespace gloam::cli
