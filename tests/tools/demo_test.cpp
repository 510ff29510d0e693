// SPDX-License-Identifier: MIT
// The first minute: `gloam demo`, its page and its pictures.
#include "tools/rendering.hpp"

namespace gloam::test::demo_test {

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

class Demo : public InFolder {};

TEST_F(Demo, SaysInTenLinesWhatItDidAndWhereToLook) {
    const fs::path out = path("demo");
    const CommandResult result =
        run_command(words("demo --out {}", out), {.timeout = std::chrono::seconds(600)});
    EXPECT_EQ(result.err, "");
    EXPECT_LE(line_count(result.out), 10) << result.out;
    for (const std::string& named : {(out / "index.html").string(), (out / "sheet.png").string()}) {
        EXPECT_THAT(result.out, HasSubstr(named));
        EXPECT_TRUE(fs::is_regular_file(named));
    }
    EXPECT_THAT(result.out, HasSubstr("equations, 4096 inputs each"));
    EXPECT_THAT(result.out, Not(HasSubstr("\033")));  // no terminal, no colour
    const std::string page = read_file(out / "index.html");
    EXPECT_THAT(page, HasSubstr("<input type=\"radio\""));
    EXPECT_THAT(page, HasSubstr("gloam_radical_inverse_base2"));
    // Every picture of the page is there, and nothing that the page does not show.
    std::vector<std::string> shown{"index.html", "sheet.png"};
    for (const char* guide : {"copy-a-shader.txt", "testing.txt", "judge-a-driver.txt"}) {
        shown.emplace_back(guide);
        EXPECT_THAT(page, HasSubstr("href=\"" + shown.back() + "\""));
    }
    EXPECT_THAT(page, AllOf(HasSubstr("<svg class=\"plot\""), HasSubstr("<details class=\"fold\">")));
    for (const char* scene : {"room", "moving"}) {
        for (const char* picture : {"plain", "shaded", "truth", "visibility", "error"}) {
            shown.push_back(std::string(scene) + "_" + picture + ".png");
            EXPECT_THAT(page, HasSubstr("src=\"" + shown.back() + "\""));
        }
    }
    const std::vector<std::string> files = files_in(out);
    EXPECT_THAT(files, testing::IsSupersetOf(shown));
    EXPECT_EQ(files.size(), shown.size() + 5);  // those of the bunny, or of the knot
}

class LitPictures : public Rendering {
  protected:
    LitPictures() { always_ = words("--size 64x36 --samples 4"); }

    [[nodiscard]] fs::path cube() const {
        return write("cube.obj",
                     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n"
                     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    }
};

TEST_F(LitPictures, ComeWithTheOcclusion) {
    expect_success(render("out", "corner --frames 2"));
    for (const char* name :
         {"sheet.png", "f0001_plain.png", "f0001_shaded.png", "f0001_true.png", "f0001_error.png"})
        EXPECT_TRUE(fs::is_regular_file(path("out") / name)) << name;
    EXPECT_FALSE(fs::exists(path("out") / "f0000_shaded.png"));  // of the last frame alone
    EXPECT_NE(read_file(path("out") / "f0001_plain.png"), read_file(path("out") / "f0001_shaded.png"));
}

TEST_F(LitPictures, SeveralMethodsAreComparedInATable) {
    const std::string result = output_of(render("out", "corner --method gtao,hemisphere"));
    for (const char* line : {"run", "gtao", "hemisphere", "closed form"})
        EXPECT_THAT(result, HasSubstr(line));
    for (const char* name : {"sheet.png", "gtao_render.json", "hemisphere_f0000_ao.pfm"})
        EXPECT_TRUE(fs::is_regular_file(path("out") / name)) << name;
}

TEST_F(LitPictures, PresetsAreCompared) {
    const std::string result = output_of(render("out", "corner --preset fast,tssao-paper"));
    for (const char* line : {"fast", "tssao-paper", "closed form"}) EXPECT_THAT(result, HasSubstr(line));
    const auto preset = [&](const std::string& name) {
        return json::parse(read_file(path("out") / (name + "_render.json"))).at("preset");
    };
    EXPECT_EQ(preset("fast"), "fast");
    EXPECT_EQ(preset("tssao-paper"), "tssao-paper");
    // A preset of a file has the file's name.
    const fs::path file = write("mine.json", R"({"settings": {"samples": 4}})");
    expect_success(render("files", "corner --preset {}", "fast," + file.string()));
    EXPECT_TRUE(fs::is_regular_file(path("files") / "mine_render.json"));
    // A run among others is the run alone.
    const std::string among = read_file(path("out") / "fast_f0000_ao.pfm");
    expect_success(render("out", "corner --preset fast"));
    EXPECT_EQ(among, read_file(path("out") / "f0000_ao.pfm"));
}

TEST_F(LitPictures, AntialiasingSmoothsThePicturesAlone) {
    for (const char* samples : {"1", "3"}) expect_success(render(samples, "columns --antialias {}", samples));
    EXPECT_EQ(read_file(path("1") / "f0000_ao.pfm"), read_file(path("3") / "f0000_ao.pfm"));
    EXPECT_NE(read_file(path("1") / "f0000_plain.png"), read_file(path("3") / "f0000_plain.png"));
}

// A unit is a metre, a millimetre or a hundred kilometres: powers of two, so that the pictures are equal to
// the bit.
TEST_F(LitPictures, AMeshOfAnyUnitHasTheSameOcclusion) {
    std::vector<std::string> shown;
    for (const std::string unit : {"1", "0.0009765625", "131072", "16777216"}) {
        std::string text;
        for (const std::string& x : {std::string("0"), unit})
            for (const std::string& y : {std::string("0"), unit})
                for (const std::string& z : {std::string("0"), unit})
                    text += "v " + x + " " + y + " " + z + "\n";
        const fs::path box = write("box.obj", text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\n");
        expect_success(render(unit, "{} --fovy 60 --preset quality --frames 2", box));
        shown.push_back(read_file(path(unit) / "f0001_ao.pfm"));
    }
    for (const std::string& image : shown) EXPECT_EQ(image, shown.front());
}

// gloam site: the files that it writes. The site itself is used in tests/site.

class SiteTest : public InFolder {};

// The JSON between the first and the last of two characters of a file.
json json_in(const fs::path& file, char begin, char end) {
    const std::string text = read_file(file);
    const std::size_t first = text.find(begin);
    return json::parse(text.substr(first, text.rfind(end) - first + 1));
}

TEST_F(SiteTest, WritesPagesAndTheChecksOfEachPart) {
    const fs::path site = path("site");
    const CommandResult result = gloam("site {} HALTON* TSSAO-11 --inputs 40 --no-pictures", site);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("index.html: "));
    for (const char* page : {"index.html", "check.html", "check.js", "style.css"})
        EXPECT_TRUE(fs::exists(site / page)) << page;
    EXPECT_THAT(read_file(site / "check.html"),
                AllOf(StartsWith("<!DOCTYPE html>\n"), HasSubstr("<title>gloam: check this browser</title>"),
                      HasSubstr("<main>\n<h1>Check this browser</h1>\n"), Not(HasSubstr("<!-- main -->"))));
    const json index = json_in(site / "site.js", '{', '}');
    EXPECT_EQ(index.at("files"), (json{"checks-filter.js", "checks-sampling.js"}));
    EXPECT_EQ(index.at("inputs"), 40);
    const json checks = json_in(site / "checks-filter.js", '[', ']');
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_EQ(checks.front().at("equation"), "TSSAO-11");
    EXPECT_EQ(checks.front().at("scenarios").front().at("count"), 40);
    EXPECT_THAT(checks.front().at("kernel").get<std::string>(),
                AllOf(HasSubstr("#version 300 es\n"), Not(HasSubstr("//")), Not(HasSubstr("#undef"))));
}

TEST_F(SiteTest, TheSameSeedGivesTheSameFiles) {
    for (const char* name : {"a", "b", "c"}) {
        const std::string seed = name == std::string("c") ? "2" : "1";
        EXPECT_EQ(gloam("site {} TSSAO-11 --seed {} --no-pictures", path(name), seed).status, 0);
    }
    const auto text = [&](const char* name) { return read_file(path(name) / "checks-filter.js"); };
    EXPECT_EQ(text("a"), text("b"));
    EXPECT_NE(text("a"), text("c"));
}

}  // namespace gloam::test::demo_test
