// SPDX-License-Identifier: MIT
// An output that cannot be written is an error, wherever it goes; and no other file replaces a closed stream.
#include <sys/resource.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "support/full_disk.hpp"
#include "tools/expect.hpp"

namespace gloam::test {
namespace streams_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> small_check{"check", "gloam_radical_inverse_base2", "--inputs", "64"};

std::vector<std::string> with_json(std::vector<std::string> command, const fs::path& file) {
    command.insert(command.end(), {"--json", file.string()});
    return command;
}

TEST(Streams, AFullStandardOutputIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryDirectory scratch;
    const fs::path file = scratch.path() / "a.json";
    expect_success(run_command(with_json(small_check, file)));
    const std::vector<std::vector<std::string>> commands{
        {"list", "presets"},
        {"--help"},
        {"devices"},
        {"devices", "--json"},
        small_check,
        {"report", file.string()},
        {"pack", "gloam/geometry/background.glsl"},
        {"render", "corner", "--size", "16x9", "--samples", "1", "--out", (scratch.path() / "out").string()}};
    for (const auto& command : commands) {
        const CommandResult result = run_command(command, {.standard_output = "/dev/full"});
        EXPECT_EQ(result.status, 2) << command.front();
        EXPECT_EQ(line_count(result.err), 1) << result.err;
        EXPECT_THAT(result.err, HasSubstr("standard output")) << command.front();
    }
}

TEST(Streams, ClosedStreamsFailNoCheck) {
    const TemporaryDirectory scratch;
    const fs::path file = scratch.path() / "a.json";
    const CommandResult result = run_command(with_json(small_check, file), {.closed_streams = true});
    EXPECT_EQ(result.status, 2);  // its table went nowhere
    EXPECT_THAT(result.err, HasSubstr("standard output"));
    std::ifstream stream(file);
    const auto report = nlohmann::json::parse(stream);
    EXPECT_EQ(report.at("results").at(0).at("error"), "");
    EXPECT_EQ(report.at("results").at(0).at("outside"), 0);
}

TEST(Streams, AFileThatMayNotGrowIsNamed) {
    const TemporaryDirectory scratch;
    const fs::path file = scratch.path() / "a.json";
    CommandResult result;
    {
        const FullDisk disk(100);  // of the program, too
        rlimit limit{};
        getrlimit(RLIMIT_FSIZE, &limit);
        result = run_command({"list", "equations", "--json"}, {.standard_output = "/dev/null"});
        EXPECT_EQ(result.status, 0) << result.err;
        result = run_command({"pack", "gloam/geometry/background.glsl", "--out", file.string()},
                             {.standard_output = "/dev/null"});
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_FALSE(fs::exists(file));
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace streams_test
}  // namespace gloam::test
