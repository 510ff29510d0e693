// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include <gtest/gtest.h>

namespace gloam::base {
namespace threads_test {

TEST(Threads, SharesCoverEveryIndexOnceAndAreNeverEmpty) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 8U, 1000U}) {
        for (const std::size_t most : {1U, 2U, 3U, 16U}) {
            const std::vector<Range> shares = shares_of(count, most);
            EXPECT_LE(shares.size(), most);
            std::size_t next = 0;
            for (const Range& share : shares) {
                EXPECT_EQ(share.begin, next);
                EXPECT_LT(share.begin, share.end);
                next = share.end;
            }
            EXPECT_EQ(next, count) << most;
        }
    }
    EXPECT_GE(processors(), 1U);
}

}  // namespace threads_test
}  // namespace gloam::base
