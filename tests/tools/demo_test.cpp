// SPDX-License-Identifier: MIT
// The first minute: `gloam demo`, its page and its pictures.
#include "tools/gloam.hpp"

namespace gloam::test::demo_test {

class Demo : public InFolder {};

TEST_F(Demo, SaysInTenLinesWhatItDidAndWhereToLook) {
    const fs::path out = path("demo");
    const CommandResult result =
        run_command(words("demo --out {}", out), {.timeout = std::chrono::seconds(600)});
    EXPECT_EQ(result.err, "");
    EXPECT_LE(line_count(result.out), 10) << result.out;
    EXPECT_THAT(result.out,
                AllOf(HasSubstr((out / "index.html").string()), HasSubstr((out / "sheet.png").string()),
                      HasSubstr("equations, 4096 inputs each")));
    EXPECT_THAT(result.out, Not(HasSubstr("\033")));  // no terminal, no colour
    const std::string page = read_file(out / "index.html");
    EXPECT_THAT(page, AllOf(HasSubstr("<input type=\"radio\""), HasSubstr("gloam_radical_inverse_base2"),
                            HasSubstr("<svg class=\"plot\""), HasSubstr("<details class=\"fold\">")));
    // Every picture of the page is there, and nothing that the page does not show.
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(out)) files.insert(entry.path().filename().string());
    std::set<std::string> shown{"index.html", "sheet.png"};
    for (const char* guide : {"copy-a-shader.txt", "testing.txt", "judge-a-driver.txt"}) {
        shown.emplace(guide);
        EXPECT_THAT(page, HasSubstr("href=\"" + std::string(guide) + "\""));
    }
    for (const char* scene : {"room", "moving"}) {
        for (const char* picture : {"plain", "shaded", "truth", "visibility", "error"}) {
            const std::string name = std::string(scene) + "_" + picture + ".png";
            shown.insert(name);
            EXPECT_THAT(page, HasSubstr("src=\"" + name + "\""));
        }
    }
    EXPECT_THAT(files, testing::IsSupersetOf(shown));
    EXPECT_EQ(files.size(), shown.size() + 5);  // those of the bunny, or of the knot
}

}  // namespace gloam::test::demo_test
