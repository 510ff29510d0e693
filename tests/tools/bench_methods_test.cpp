// SPDX-License-Identifier: MIT
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_methods_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

void write_file(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string page_with(const std::vector<std::string>& blocks) {
    std::string page = "# Methods\n";
    for (const std::string& name : blocks)
        page += "before " + name + "\n<!-- begin " + name + " -->\nold\n<!-- end " + name + " -->\n";
    return page + "after\n";
}

const std::vector<std::string> all_blocks{"estimates", "views", "bias", "scenes", "pictures"};

TEST(BenchMethods, WritesTablesPicturesAndNumbers) {
    const TemporaryDirectory folder;
    const auto page = folder.path() / "methods.md";
    const auto file = folder.path() / "methods.json";
    const auto out = folder.path() / "pictures";
    write_file(page, page_with(all_blocks));
    const CommandResult result =
        run_command({"bench",      "methods",    "--scene", "corner",       "--method", "gtao",
                     "volumetric", "--size",     "32x18",   "--rays",       "32",       "--pixels",
                     "65",         "--frames",   "4",       "--validation", "--json",   file.string(),
                     "--out",      out.string(), "--page",  page.string()});
    expect_success(result);
    const std::string text = read_file(page);
    EXPECT_THAT(text, Not(HasSubstr("old")));
    EXPECT_THAT(text,
                HasSubstr("before views\n<!-- begin views -->\n\n| configuration | planes | wall 0.25 |"));
    EXPECT_THAT(text, HasSubstr("| volumetric | 0.500 |"));
    EXPECT_THAT(text, HasSubstr("images/methods/corner-gtao.png"));
    EXPECT_THAT(read_file(out / "corner-volumetric.png"), HasSubstr("PNG"));
    EXPECT_THAT(read_file(out / "corner-truth.png"), HasSubstr("PNG"));
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    EXPECT_GE(document.at("depth_against_geometry").at("corner").at("rmse"), 0.0);
    ASSERT_EQ(document.at("configurations").size(), 4U);  // both and their presets
    for (const json& row : document.at("configurations")) {
        EXPECT_EQ(row.at("views").size(), 13U);
        EXPECT_GT(row.at("scenes").at(0).at("limit").at("geometry").at("rmse"), 0.0);
        EXPECT_GT(row.at("scenes").at(0).at("gather_ms"), 0.0);
        // The first view is a bare plane.
        const double open = row.at("method") == "volumetric" ? 0.5 : 0.0;
        for (const char* what : {"measured", "own"})
            EXPECT_NEAR(double{row.at("views").at(0).at(what).at("value")}, open, 1e-5) << row.at("name");
        EXPECT_EQ(double{row.at("views").at(0).at("truth")}, 0.0);
    }
}

TEST(BenchMethods, BadInputIsOneClearLine) {
    const TemporaryDirectory folder;
    const auto page = folder.path() / "page.md";
    write_file(page, page_with({"estimates", "views", "bias", "scenes"}));
    const std::string before = read_file(page);
    const auto bench = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"bench", "methods"});
        return run_command(arguments);
    };
    expect_could_not_run(bench({"--scene", "nowhere"}), "nowhere");
    expect_could_not_run(bench({"--method", "magic"}), "magic");
    expect_could_not_run(bench({"--size", "1x1"}), "--size 1x1");
    expect_could_not_run(bench({"--pixels", "64"}), "odd");
    expect_could_not_run(bench({"--pixels", "3"}), "--pixels");
    expect_could_not_run(bench({"--frames", "1"}), "--frames");
    expect_could_not_run(bench({"--rays", "1"}), "--rays");
    expect_could_not_run(bench({"--json", "/no/such/folder/a.json"}), "/no/such/folder");
    expect_could_not_run(bench({"--page", "/no/such/page.md"}), "/no/such/page.md");
    expect_could_not_run(bench({"--page", page.string()}), "begin pictures");
    EXPECT_EQ(read_file(page), before);
}

}  // namespace bench_methods_test
}  // namespace gloam::test
