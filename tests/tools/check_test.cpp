// SPDX-License-Identifier: MIT
#include <csignal>

#include "base/process.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::check_test {

class CheckResume : public InFolder {
  protected:
    [[nodiscard]] std::vector<std::string> command(std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"check", "TSSAO-*", "--inputs", "64", "--json", results().string()};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] fs::path results() const { return path("results.json"); }
    [[nodiscard]] fs::path journal() const { return path("results.json.journal"); }

    // The lines that stand in the journal whole.
    [[nodiscard]] std::vector<std::string> kept() const {
        std::ifstream stream(journal());
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line) && !stream.eof();) lines.push_back(line);
        return lines;
    }

    // Runs the check until some results stand in the journal, and kills it then.
    void run_and_kill() {
        std::vector<std::string> words = command();
        words.insert(words.begin(), GLOAM_BUILT_BINARY);
        base::WorkerProcess check(words);
        constexpr std::size_t enough = 4;  // the heading and three results
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (kept().size() < enough && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ASSERT_EQ(kill(check.id(), SIGKILL), 0);
        ASSERT_THAT(check.end(), HasSubstr("signal 9")) << "it ended before it was killed";
        ASSERT_GE(kept().size(), enough);
    }
};

TEST_F(CheckResume, AKilledRunLeavesItsResultsAndTheNextGoesOnFromThere) {
    run_and_kill();
    EXPECT_FALSE(fs::exists(results()));
    std::map<std::string, double> seconds;
    const std::vector<std::string> lines = kept();
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const json row = json::parse(lines[i]).at("row");
        seconds[row.at("equation")] = row.at("seconds");
    }
    // Results of other inputs are not taken over, and a line that is no result is named.
    const CommandResult other = run_command(command(words("--resume --seed 2")));
    expect_could_not_run(other, journal().string());
    EXPECT_THAT(other.err, HasSubstr("\"seed\":2"));
    const std::string whole = read_file(journal()).substr(0, read_file(journal()).rfind('\n') + 1);
    write("results.json.journal", whole + "{}\n");
    expect_could_not_run(run_command(command(words("--resume"))), journal().string() + ", line ");

    for (const char* how : {"--resume", "--resume --in-process"}) {
        write("results.json.journal", whole + R"({"device": "cut of)");  // as a kill may leave it
        const std::string resumed = output_of(run_command(command(words(how))));
        EXPECT_FALSE(fs::exists(journal()));
        const json rows = json::parse(read_file(results())).at("results");
        EXPECT_GT(rows.size(), seconds.size());
        for (const auto& [equation, time] : seconds) {
            const auto row = std::find_if(rows.begin(), rows.end(), [&name = equation](const json& r) {
                return r.at("equation") == name;
            });
            ASSERT_NE(row, rows.end()) << equation;
            EXPECT_EQ(row->at("seconds"), time) << equation << " was run again";
            EXPECT_THAT(resumed, HasSubstr(equation));
        }
    }
}

// Passes, on the devices that this machine has: the study's, and the frame of each own preset.
TEST(CheckPasses, AreRight) {
    for (const char* device : {"", "interpreter", "gl:llvmpipe-4.5", "es:llvmpipe-3.1"}) {
        const CommandResult result =
            *device == '\0' ? gloam("check PASS-*") : gloam("check PASS-* --device {}", device);
        if (result.status == 2) continue;  // there is none
        const bool es = std::string_view(device).starts_with("es");
        EXPECT_THAT(output_of(result),
                    HasSubstr(es ? "8 checks, 0 failed, 4 not judged" : "8 checks, 0 failed\n"))
            << device;
    }
}

TEST(CheckPasses, WithAFaultFail) {
    const Installation broken;
    for (const auto& [pass, store] : {std::pair{"reproject", "imageStore(history, pixel, "},
                                      {"ambient_occlusion", "imageStore(history_after, pixel, "},
                                      {"spatial_filter", "imageStore(filtered_image, pixel, "},
                                      {"remap", "imageStore(mapped_image, pixel, "}})
        broken.replace("passes/study/" + std::string(pass) + ".comp", store,
                       std::string(store) + "vec4(pixel.x == 3 ? 2e-6 : 0.0) + ");
    const CommandResult study = broken.gloam("check PASS-* --device interpreter");
    EXPECT_THAT(study.out, HasSubstr("8 checks, 4 failed"));
    EXPECT_THAT(study.out, HasSubstr("ivec2 (3, "));
    // As a driver would have it that is wrong.
    broken.replace("passes/frame/sweep.glsl", "float place = places.x",
                   "#ifndef VULKAN\nplaces *= 0.9;\n#endif\nfloat place = places.x");
    broken.replace("passes/frame/join.glsl",
                   "float spatial = ", "#ifndef VULKAN\ntent.x += 0.01;\n#endif\nfloat spatial = ");
    const CommandResult frame = broken.gloam("check PASS-frame-* --device gl:llvmpipe-4.5");
    if (frame.status == 2) GTEST_SKIP() << frame.err;
    EXPECT_THAT(frame.out, HasSubstr("4 checks, 4 failed"));
    EXPECT_THAT(frame.out, AllOf(HasSubstr("images sweep: texels"), HasSubstr("images join: shown")));
}

}  // namespace gloam::test::check_test
