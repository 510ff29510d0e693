// SPDX-License-Identifier: MIT
// The first minute: `gloam demo`, its page and its pictures.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "tools/expect.hpp"

namespace gloam::test {
namespace demo_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

TEST(Demo, SaysInTenLinesWhatItDidAndWhereToLook) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "demo";
    const CommandResult result =
        run_command({"demo", "--out", out.string()}, {.timeout = std::chrono::seconds(600)});
    EXPECT_EQ(result.err, "");
    EXPECT_LE(line_count(result.out), 10) << result.out;
    for (const std::string& named : {(out / "index.html").string(), (out / "sheet.png").string()}) {
        EXPECT_THAT(result.out, HasSubstr(named));
        EXPECT_TRUE(fs::is_regular_file(named));
    }
    EXPECT_THAT(result.out, HasSubstr("equations, 4096 inputs each"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("\033")));  // no terminal, no colour
    const std::string page = bytes_of(out / "index.html");
    EXPECT_THAT(page, HasSubstr("<input type=\"range\""));
    EXPECT_THAT(page, HasSubstr("gloam_radical_inverse_base2"));
    // Every picture of the page is there, and nothing that the page does not show.
    std::vector<std::string> shown{"index.html", "sheet.png"};
    for (const char* scene : {"columns", "moving"}) {
        for (const char* picture : {"plain", "shaded", "visibility", "error"}) {
            shown.push_back(std::string(scene) + "_" + picture + ".png");
            EXPECT_THAT(page, HasSubstr("src=\"" + shown.back() + "\""));
        }
    }
    const std::vector<std::string> files = files_in(out);
    EXPECT_THAT(files, testing::IsSupersetOf(shown));
    EXPECT_EQ(files.size(), shown.size() + 4);  // those of the bunny, or of the knot
}

TEST(Demo, AFolderThatCannotBeWrittenIsNamedBeforeTheWork) {
    expect_could_not_run(run_command({"demo", "--out", "/proc/gloam"}), "/proc/gloam");
}

class Gallery : public testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }

    [[nodiscard]] CommandResult render(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(),
                         {"--size", "64x36", "--samples", "4", "--out", path("out").string()});
        return run_command(arguments);
    }

    [[nodiscard]] std::string cube() const {
        std::ofstream(path("cube.obj"))
            << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n"
            << "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
        return path("cube.obj").string();
    }

  private:
    TemporaryDirectory folder_;
};

TEST_F(Gallery, LitPicturesComeWithTheOcclusion) {
    expect_success(render({"corner", "--frames", "2"}));
    for (const char* name : {"sheet.png", "f0001_plain.png", "f0001_shaded.png", "f0001_error.png"})
        EXPECT_TRUE(fs::is_regular_file(path("out") / name)) << name;
    EXPECT_FALSE(fs::exists(path("out") / "f0000_shaded.png"));  // of the last frame alone
    EXPECT_NE(bytes_of(path("out") / "f0001_plain.png"), bytes_of(path("out") / "f0001_shaded.png"));
}

TEST_F(Gallery, SeveralMethodsAreComparedInATable) {
    const CommandResult result =
        render({"corner", "--method", "gtao,hemisphere", "--gallery", path("page").string()});
    expect_success(result);
    for (const char* line : {"method", "gtao", "hemisphere", "closed form"})
        EXPECT_THAT(result.out, HasSubstr(line));
    for (const char* name : {"sheet.png", "gtao_render.json", "hemisphere_f0000_ao.pfm"})
        EXPECT_TRUE(fs::is_regular_file(path("out") / name)) << name;
    const std::string page = bytes_of(path("page") / "index.html");
    for (const char* name : {"gtao_plain.png", "hemisphere_shaded.png", "hemisphere_error.png"}) {
        EXPECT_THAT(page, HasSubstr(name));
        EXPECT_TRUE(fs::is_regular_file(path("page") / name)) << name;
    }
}

TEST_F(Gallery, AMethodAmongOthersIsTheMethodAlone) {
    expect_success(render({"corner", "--method", "gtao,hemisphere"}));
    const std::string among = bytes_of(path("out") / "gtao_f0000_ao.pfm");
    expect_success(render({"corner", "--method", "gtao"}));
    EXPECT_EQ(among, bytes_of(path("out") / "f0000_ao.pfm"));
}

TEST_F(Gallery, ATurntableShowsEveryView) {
    expect_success(render({cube(), "--up", "z", "--turntable", "3", "--gallery", path("page").string()}));
    const std::string page = bytes_of(path("page") / "index.html");
    for (const char* name : {"_view0000.png", "_view0001.png", "_view0002.png"})
        EXPECT_THAT(page, HasSubstr(name));
    EXPECT_TRUE(fs::is_regular_file(path("out") / "f0002_shaded.png"));
    EXPECT_NE(bytes_of(path("out") / "f0001_shaded.png"), bytes_of(path("out") / "f0002_shaded.png"));
}

// The name of a file that someone else made is text on the page, and no part of a path.
TEST_F(Gallery, AForeignNameIsText) {
    const fs::path hostile = path("<img src=x onerror=alert(1)>.obj");
    fs::rename(cube(), hostile);
    expect_success(render({hostile.string(), "--gallery", path("page").string()}));
    const std::string page = bytes_of(path("page") / "index.html");
    EXPECT_THAT(page, testing::Not(HasSubstr("<img src=x")));
    EXPECT_THAT(page, HasSubstr("&lt;img src=x onerror=alert(1)&gt;"));
    for (const std::string& name : files_in(path("page")))
        EXPECT_THAT(name, testing::Not(HasSubstr("onerror")));
}

TEST_F(Gallery, WrongViewsAreNamed) {
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& named) {
        expect_could_not_run(render(arguments), named);
        EXPECT_FALSE(fs::exists(path("out"))) << named;
    };
    refused({cube(), "--up", "w"}, "--up w");
    refused({cube(), "--eye", "1,2"}, "--eye 1,2");
    refused({cube(), "--eye", "1,2,inf"}, "--eye 1,2,inf");
    refused({cube(), "--orbit", "1,2,3"}, "--orbit 1,2,3");
    refused({cube(), "--orbit", "0,95"}, "elevation");
    refused({cube(), "--eye", "0,0.5,0"}, "eye");
    refused({cube(), "--eye", "1,1,1", "--orbit", "1,1"}, "--orbit");
    refused({"corner", "--turntable", "4"}, "camera of its own");
    refused({"corner", "--method", "gtao,no-such-method"}, "no-such-method");
    refused({"corner", "--method", "gtao,hbao", "--write-gbuffer", path("g").string()}, "--write-gbuffer");
}

}  // namespace demo_test
}  // namespace gloam::test
