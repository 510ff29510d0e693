// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "support/run_command.hpp"
#include "support/test.hpp"

// The program, run as its users run it.
namespace gloam::test {

namespace fs = std::filesystem;
using nlohmann::json;
using Arguments = std::vector<std::string>;

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

// The manifest of Mesa's lavapipe; empty: it is not here.
inline fs::path installed_lavapipe() {
    const fs::path folder = "/usr/share/vulkan/icd.d";
    if (fs::exists(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().starts_with("lvp_icd")) return entry.path();
    return {};
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
    [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

    // Replaces the first place in a shader file where `from` stands.
    void replace(const fs::path& file, const std::string& from, const std::string& to) const {
        std::string text = read_file(glsl() / file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
        std::ofstream(glsl() / file) << text.replace(at, from.size(), to);
    }

    // Makes results of gloam_radical_inverse_base2 wrong; the first such index is 1.
    void spoil_radical_inverse_base2() const {
        replace("gloam/sampling/halton.glsl", "0.000244140625", "0.00024414066");
    }

    // Makes gloam_radical_inverse_base2 loop until a generator of period 2^32 returns to a certain number.
    // lavapipe ends loops after 65,535 rounds without a word: these are so long that it is busy for minutes.
    void make_radical_inverse_base2_hang() const {
        std::string loop = "uint spin = index;\n    for (uint i = 0u; spin != 305419896u; ++i) {\n";
        for (int i = 0; i < 200; ++i) loop += "        spin = (spin ^ i) * 1664525u + 1013904223u;\n";
        replace("gloam/sampling/halton.glsl", "uint bits = bitfieldReverse(index)",
                loop + "    }\n    uint bits = (spin & 1u) + bitfieldReverse(index)");
    }

    // Its program, run with the words of a line.
    template <class... Texts>
    [[nodiscard]] CommandResult gloam(std::string_view line, const Texts&... arguments) const {
        return run_program(program(), words(line, arguments...));
    }

  private:
    TemporaryDirectory folder_;
};

}  // namespace gloam::test
