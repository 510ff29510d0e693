// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "support/matchers.hpp"
#include "support/run_command.hpp"

namespace gloam::test {

// The command could not run: status 2, nothing on standard output, and one line on standard error with the
// error.
inline void expect_could_not_run(const CommandResult& result, const std::string& named) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(line_count(result.err), 1) << result.err;
    EXPECT_THAT(result.err, StartsWith("gloam: "));
    EXPECT_THAT(result.err, HasSubstr(named));
}

// It ran, and had nothing to complain about.
inline void expect_success(const CommandResult& result) {
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_EQ(result.err, "");
}

// Of one that did, what it wrote to standard output.
inline std::string output_of(const CommandResult& result) {
    expect_success(result);
    return result.out;
}

// Tests with a folder of their own.
class InFolder : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

    // Where the file with that text is.
    std::filesystem::path write(const std::string& name, std::string_view text) const {
        return folder_.write(name, text);
    }

  private:
    TemporaryDirectory folder_;
};

}  // namespace gloam::test
