// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "support/run_command.hpp"
#include "support/test.hpp"

// The program, run as its users run it.
namespace gloam::test {

namespace fs = std::filesystem;
using nlohmann::json;

// The command could not run: status 2, nothing on standard output, and its error in a line on standard error.
inline void expect_could_not_run(const CommandResult& result, const std::string& named) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
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

// An installation of its own, whose shaders a test may break: the program beside share/gloam/glsl.
class Installation {
  public:
    Installation() {
        fs::create_directories(folder_.path() / "bin");
        fs::create_directories(folder_.path() / "share" / "gloam");
        fs::copy_file(GLOAM_BUILT_BINARY, program());
        fs::copy(GLOAM_GLSL_DIR, glsl(), fs::copy_options::recursive);
    }

    [[nodiscard]] fs::path program() const { return folder_.path() / "bin" / "gloam"; }
    [[nodiscard]] fs::path glsl() const { return folder_.path() / "share" / "gloam" / "glsl"; }

    // Replaces the first place in a shader file where `from` stands.
    void replace(const fs::path& file, const std::string& from, const std::string& to) const {
        std::string text = read_file(glsl() / file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
        std::ofstream(glsl() / file) << text.replace(at, from.size(), to);
    }

  private:
    TemporaryDirectory folder_;
};

}  // namespace gloam::test
