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
using Arguments = std::vector<std::string>;

std::filesystem::path page_with(const std::filesystem::path& folder, const Arguments& blocks) {
    std::ofstream page(folder / "methods.md");
    for (const std::string& name : blocks)
        page << "before " << name << "\n<!-- begin " << name << " -->\nold\n<!-- end " << name << " -->\n";
    return folder / "methods.md";
}

void expect_plausible(const json& point, const std::string& candidate) {
    EXPECT_EQ(double{point.at("truth")}, 0.0);
    if (candidate == "truth") return;
    const double open = candidate.find("volumetric") != std::string::npos ? 0.5 : 0.0;
    for (const char* what : {"occlusion", "own"})
        EXPECT_NEAR(double{point.at(what)}, open, 1e-5) << candidate;
}

TEST(BenchMethods, WritesTablesPicturesAndNumbers) {
    const TemporaryDirectory folder;
    const auto page = page_with(folder.path(), {"views", "bias", "scenes"});
    const auto file = folder.path() / "methods.json";
    const auto out = folder.path() / "pictures";
    const CommandResult result =
        run_command({"bench",    "methods",     "--case",     "corner",     "plane 0", "wall 0.25",
                     "--method", "gtao",        "volumetric", "--size",     "32x18",   "--rays",
                     "32",       "--frames",    "4",          "--rounds",   "1",       "--validation",
                     "--json",   file.string(), "--out",      out.string(), "--page",  page.string()});
    expect_success(result);
    const std::string text = read_file(page);
    EXPECT_THAT(text, Not(HasSubstr("old")));
    EXPECT_THAT(text, HasSubstr("| configuration, with its own value | planes | wall 0.25 | furthest"));
    EXPECT_THAT(text, HasSubstr("| truth | 0.000 | 0."));
    EXPECT_THAT(text, HasSubstr("| volumetric | 0.500 |"));
    EXPECT_THAT(text, HasSubstr("| truth of the depth buffer (D) | 0."));
    EXPECT_THAT(text, Not(HasSubstr("| truth | - |"))) << "a row in which nothing is known";
    for (const char* name : {"volumetric-converged", "truth-visibility"})
        EXPECT_THAT(read_file(out / ("corner-" + std::string(name) + ".png")), HasSubstr("PNG"));
    const json document = json::parse(read_file(file));
    std::size_t converged = 0;
    for (const json& visit : document.at("visits")) {
        const std::string candidate = visit.at("candidate");
        if (visit.at("case") == "plane 0" && visit.contains("point"))
            expect_plausible(visit.at("point"), candidate);
        if (!visit.contains("quality") || !visit.at("quality").contains("converged")) continue;
        const json& quality = visit.at("quality").at("converged");
        EXPECT_GT(quality.at("geometry").at("rmse"), 0.0);
        EXPECT_LE(quality.at("remapped").at("rmse"), quality.at("geometry").at("rmse"));
        EXPECT_EQ(quality.contains("own"), candidate == "gtao") << candidate;
        ++converged;
    }
    EXPECT_EQ(converged, 4U) << "both methods, the preset of one, and (D)";
}

TEST(BenchMethods, BadInputIsOneClearLine) {
    const TemporaryDirectory folder;
    const auto page = page_with(folder.path(), {"views", "bias"});
    const std::string before = read_file(page);
    const auto bench = [](Arguments arguments) {
        arguments.insert(arguments.begin(), {"bench", "methods"});
        return run_command(arguments);
    };
    expect_could_not_run(bench({"--case", "nowhere"}), "nowhere");
    expect_could_not_run(bench({"--method", "magic"}), "magic");
    expect_could_not_run(bench({"--size", "1x1"}), "--size 1x1");
    expect_could_not_run(bench({"--frames", "1"}), "plane 0: 1 frames, expected 2 or more");
    expect_could_not_run(bench({"--json", "/no/such/folder/a.json"}), "/no/such/folder");
    expect_could_not_run(bench({"--page", "/no/such/page.md"}), "/no/such/page.md");
    expect_could_not_run(bench({"--page", page.string()}), "begin scenes");
    EXPECT_EQ(read_file(page), before);
}

}  // namespace bench_methods_test
}  // namespace gloam::test
