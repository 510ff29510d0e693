// SPDX-License-Identifier: MIT
// `gloam check --exit-code`, and what `git bisect run` makes of it.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test::bisect_test {

namespace fs = std::filesystem;

constexpr int skip_this_build = 125;

class Bisect : public InFolder {
  protected:
    [[nodiscard]] static std::string manifest_of(const std::string& library) {
        return nlohmann::json{{"file_format_version", "1.0.0"},
                              {"ICD", {{"library_path", library}, {"api_version", "1.3.0"}}}}
            .dump();
    }
    // Git in a repository of its own, without the settings of this machine.
    template <class... Texts>
    [[nodiscard]] CommandResult git(std::string_view line, const Texts&... arguments) const {
        const std::string path =
            fs::path(GLOAM_BUILT_BINARY).parent_path().string() + ":" + std::getenv("PATH");
        return run_program(
            "/usr/bin/git", words(line, arguments...),
            {.environment = {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_SYSTEM=/dev/null",
                             "GIT_AUTHOR_NAME=a", "GIT_AUTHOR_EMAIL=a", "GIT_COMMITTER_NAME=a",
                             "GIT_COMMITTER_EMAIL=a", "BUILD=cp source.json icd.json", "PATH=" + path},
             .working_directory = this->path("")});
    }
    // Commits a revision of the driver; returns its hash.
    [[nodiscard]] std::string commit(int number, const std::string& manifest) const {
        write("number", std::to_string(number));
        if (manifest.empty()) fs::remove(path("source.json"));
        if (!manifest.empty()) write("source.json", manifest);
        EXPECT_EQ(git("add --all").status, 0);
        EXPECT_EQ(git("commit --quiet --message {}", "revision " + std::to_string(number)).status, 0);
        return git("rev-parse HEAD").out.substr(0, 40);
    }
};

// The manifest of Mesa's lavapipe; empty: it is not here.
std::string lavapipe() {
    const fs::path folder = "/usr/share/vulkan/icd.d";
    if (fs::exists(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().starts_with("lvp_icd")) return read_file(entry.path());
    return "";
}

TEST_F(Bisect, TheStatusIsGoodBadOrSkip) {
    EXPECT_EQ(gloam("check HALTON-base2 --inputs 64 --exit-code --device interpreter").status, 0);
    const Installation installation;
    installation.spoil_radical_inverse_base2();
    EXPECT_EQ(installation.gloam("check HALTON-base2 --inputs 64 --exit-code").status, 1);
    for (const char* line : {"check nonsense --exit-code", "check HALTON-base2 --exit-code --nonsense",
                             "check HALTON-base2 --exit-code --device nonsense"}) {
        const CommandResult result = run_command(words(line));
        EXPECT_EQ(result.status, skip_this_build) << line;
        EXPECT_EQ(line_count(result.err), 1) << result.err;
    }
    EXPECT_EQ(gloam("check HALTON-base2 --device nonsense").status, 2) << "without the option";
}

TEST_F(Bisect, ADriverThatCrashesIsBadAndOneThatIsMissingIsSkipped) {
    const auto status_with = [&](const fs::path& manifest) {
        const std::string driver = manifest.string();
        return run_command(words("check HALTON-base2 --inputs 64 --exit-code"),
                           {.environment = {"VK_DRIVER_FILES=" + driver, "VK_ICD_FILENAMES=" + driver}})
            .status;
    };
    EXPECT_EQ(status_with(write("crashing.json", manifest_of(GLOAM_CRASHING_DRIVER))), 1);
    EXPECT_EQ(status_with(write("text.json", "no manifest")), skip_this_build);
    EXPECT_EQ(status_with(path("missing.json")), skip_this_build);
}

TEST_F(Bisect, GitNamesTheRevisionThatBrokeADriver) {
    const std::string good = lavapipe();
    if (good.empty()) GTEST_SKIP() << "no lavapipe here (Debian: mesa-vulkan-drivers)";
    if (!fs::exists("/usr/bin/git")) GTEST_SKIP() << "no git here";
    ASSERT_EQ(git("init --quiet").status, 0);
    write(".gitignore", "icd.json\n");
    std::string first_bad;
    for (int number = 0; number < 12; ++number) {
        const bool bad = number >= 7;
        const bool builds = number != 5 && number != 8;
        const std::string hash = commit(number, !builds ? ""
                                                : bad   ? manifest_of(GLOAM_CRASHING_DRIVER)
                                                        : good);
        if (number == 7) first_bad = hash;
    }
    ASSERT_EQ(git("bisect start HEAD HEAD~11").status, 0);
    const CommandResult result =
        git("bisect run {} icd.json HALTON-base2 --inputs 64", GLOAM_EXAMPLES "/laboratory/bisect.sh");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr(first_bad + " is the first bad commit"));
}

}  // namespace gloam::test::bisect_test
