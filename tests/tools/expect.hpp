// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "support/run_command.hpp"

namespace gloam::test {

// The command could not run: status 2, nothing on standard output, and one line on standard error with the
// error.
inline void expect_could_not_run(const CommandResult& result, const std::string& named) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(line_count(result.err), 1) << result.err;
    EXPECT_THAT(result.err, testing::StartsWith("gloam: "));
    EXPECT_THAT(result.err, testing::HasSubstr(named));
}

// It ran, and had nothing to complain about.
inline void expect_success(const CommandResult& result) {
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_EQ(result.err, "");
}

}  // namespace gloam::test
