// SPDX-License-Identifier: MIT
// The experiments of `gloam bench`: descriptions in experiments/, and a user's own.
#include <iomanip>

#include "tools/gloam.hpp"

namespace gloam::test::bench_experiments_test {

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

// Runs `gloam bench` with the validation layers, and reads what it writes.
class BenchExperiments : public InFolder {
  protected:
    json measured(Arguments arguments) {
        const fs::path file = path("results.json");
        arguments.insert(arguments.begin(), "bench");
        for (const char* word : {"--validation", "--json"}) arguments.emplace_back(word);
        arguments.push_back(file.string());
        const CommandResult result = run_command(arguments);
        expect_success(result);
        out_ = result.out;
        return json::parse(read_file(file));
    }

    // The result of a candidate in a case at the only size.
    static json result_of(const json& document, std::size_t number, const std::string& candidate) {
        for (const json& result : document.at("results"))
            if (result.at("case_number") == number + 1 && result.at("candidate") == candidate) return result;
        throw std::runtime_error("no result of " + candidate);
    }

    std::string out_;
};

TEST_F(BenchExperiments, PassesTimesEachPassOfEachState) {
    const json document = measured({"passes", "--size", "96x54", "--rounds", "1"});
    EXPECT_THAT(out_, HasSubstr("| fresh | nothing has converged: 5 x 5 taps | ambient_occlusion | "));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    ASSERT_EQ(document.at("results").size(), 17U);
    std::set<std::string> shaded;
    bool reprojected = false;
    for (const json& pass : document.at("passes")) {
        EXPECT_GT(pass.at("ms"), 0.0) << pass;
        if (pass.at("pass") == "ambient_occlusion") shaded.insert(pass.at("case"));
        reprojected |= pass.at("pass") == "reproject";
    }
    EXPECT_EQ(shaded.size(), 17U);
    EXPECT_TRUE(reprojected) << "no state in which the view moves";
}

const Arguments tiny{"--size", "48x27", "--frames", "3", "--scored", "2", "--rays", "32"};

Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_F(BenchExperiments, ViewsMeasuresPresetsOnBothHalves) {
    const fs::path page = write("page.md", "before\n<!-- begin views -->\n<!-- end views -->\nafter\n");
    const json document =
        measured(with(with({"views"}, tiny), {"--view", "moving", "room", "--single", "xegtao-ultra",
                                              "quality", "--sequence", "quality", "--page", page.string()}));
    EXPECT_THAT(read_file(page), HasSubstr(out_));
    EXPECT_THAT(out_, HasSubstr("| moving | scene | tuning |"));
    EXPECT_THAT(out_, HasSubstr("| room | scene | unseen |"));
    for (const std::size_t view : {0U, 1U}) {
        const json first = result_of(document, view, "xegtao-ultra, single");
        const json second = result_of(document, view, "quality, single");
        const json run = result_of(document, view, "quality, sequence");
        EXPECT_GT(double{result_of(document, view, "the depth buffer's truth (D)").at("rmse")}, 0.0);
        for (const json* cell : {&first, &second, &run}) {
            EXPECT_GT(double{cell->at("ms")}, 0.0);
            EXPECT_GT(double{cell->at("rmse_depth")}, 0.0);
            EXPECT_GT(double{cell->at("rmse")}, std::abs(double{cell->at("bias")}));
        }
        EXPECT_LT(double{second.at("rmse")}, double{first.at("rmse")});
        EXPECT_TRUE(first.at("flicker").is_null());
        EXPECT_FALSE(run.at("flicker").is_null());
    }
    // The means' row of a half with one view holds that view's error and its ratio to the first.
    const double error = result_of(document, 1, "quality, single").at("rmse");
    const double base = result_of(document, 1, "xegtao-ultra, single").at("rmse");
    EXPECT_THAT(out_, HasSubstr(fixed(error, 4) + " | "));
    EXPECT_THAT(out_, HasSubstr(fixed(error / base, 2) + " | "));
}

TEST_F(BenchExperiments, AHalfAloneWithoutTimes) {
    const json document =
        measured(with(with({"views"}, tiny), {"--view", "moving", "room", "--half", "unseen", "--single",
                                              "fast", "--rounds", "0", "--no-depth-truth"}));
    ASSERT_EQ(document.at("results").size(), 1U);
    EXPECT_THAT(out_, HasSubstr("| room | scene | unseen |"));
    EXPECT_THAT(out_, Not(HasSubstr("| moving |")));
    EXPECT_TRUE(result_of(document, 0, "fast, single").at("ms").is_null());
}

TEST_F(BenchExperiments, MotionJudgesClassesOfPixels) {
    const json document = measured(with({"motion"}, tiny));
    EXPECT_THAT(out_, HasSubstr("| yard | tuning | fast | 0."));
    EXPECT_THAT(out_, HasSubstr("| gallery | unseen | reference | 0."));
    for (const json& visit : document.at("visits")) {
        const json& scores = visit.at("quality").at("by_class");
        for (const char* pixels : {"moving", "near_moving"})
            EXPECT_THAT(scores.at("frames").at(0).dump(), HasSubstr(std::string("\"") + pixels + '"'));
        EXPECT_THAT(scores.at("flicker").dump(), HasSubstr("near_moving"));
        EXPECT_EQ(scores.at("flicker").at(0).at("mean"), visit.at("quality").at("flicker"));
    }
}

TEST_F(BenchExperiments, TimesWithoutErrors) {
    const json document = measured(
        words("views --size 48x27 --frames 1 --scored 1 --rays 0 --view room --single fast --rounds 1"));
    EXPECT_THAT(out_, HasSubstr("| room | scene | unseen | - | - |"));
    EXPECT_GT(result_of(document, 0, "fast, single").at("ms").get<double>(), 0.0);
}

TEST_F(BenchExperiments, FrontShowsPresetsBesideThePlainLoopAtEachSize) {
    const json document =
        measured({"front", "--size", "48x27", "64x36", "--frames", "3", "--scored", "2", "--rays", "32",
                  "--view", "room", "knot", "moving", "plan", "--sequence", "fast", "balanced,samples=16"});
    for (const char* text :
         {"48 x 27", "64 x 36", "| plain loop, 9 x 3 |", "| scene | 2 |", "| plain loop, 1 x 2 and a blur |",
          "| plain loop, 3 x 3 and 2 blurs |", "| quality, single |", "| balanced,samples=16, sequence |"})
        EXPECT_THAT(out_, HasSubstr(text));
    // Two sizes and two cases: moving is of the other half, plan is orthographic.
    ASSERT_EQ(document.at("results").size(), 2U * 2U * 6U);
    for (const std::ptrdiff_t first : {0, 12}) {
        const auto begin = document.at("results").begin() + first;
        const json size(begin, begin + 12);
        const json runs(begin, begin + 6);
        for (const json& run : runs) EXPECT_GT(double{run.at("ms")}, 0.0);
        EXPECT_GT(double{runs.at(1).at("rmse")}, double{runs.at(0).at("rmse")});
        EXPECT_LT(double{runs.at(3).at("rmse")}, double{runs.at(0).at("rmse")});
        EXPECT_TRUE(runs.at(3).at("flicker").is_null());
        EXPECT_GT(double{runs.at(4).at("flicker")}, 0.0);
        const auto mean_of = [&](std::size_t run) {
            return (double{size.at(run).at("rmse")} + double{size.at(run + 6).at("rmse")}) / 2.0;
        };
        EXPECT_THAT(out_, testing::ContainsRegex(fixed(mean_of(3), 4) + "(\\*\\*)? \\| " +
                                                 fixed(mean_of(3) / mean_of(0), 2) + " \\| "));
    }
}

std::ptrdiff_t passes_of(const json& document, std::size_t number, const std::string& candidate) {
    return std::ranges::count_if(document.at("passes"), [&](const json& pass) {
        return pass.at("case_number") == number + 1 && pass.at("candidate") == candidate;
    });
}

// Each experiment has all its rows, equal configurations have equal errors, and the tables have their blocks.
TEST_F(BenchExperiments, SourcesRepeatsWhatIsPrinted) {
    const fs::path page =
        write("page.md",
              "<!-- begin issao_table -->\n<!-- end issao_table -->\n<!-- begin quality -->\n"
              "old\n<!-- end quality -->\n<!-- begin radius -->\nold\n<!-- end radius -->\n");
    const json document = measured({"sources", "--case", "knot", "relief", "--size", "64x36", "--rounds", "1",
                                    "--rays", "32", "--page", page.string()});
    ASSERT_EQ(document.at("results").size(), 4U * 2U + 7U + 6U * 3U);
    for (std::size_t i = 0; i < 4; ++i) {
        const json plain = result_of(document, i, "no filter");
        const json filtered = result_of(document, i, "bilateral");
        EXPECT_LT(passes_of(document, i, "no filter"), passes_of(document, i, "bilateral"));
        EXPECT_EQ(plain.at("samples"), filtered.at("samples"));
        EXPECT_NE(plain.at("rmse"), filtered.at("rmse"));
        EXPECT_EQ(plain.at("rmse"), plain.at("rmse_own_radius"));
    }
    for (std::size_t i = 4; i < 11; ++i) {
        const json found = result_of(document, i, "enough samples");
        EXPECT_LE(found.at("rmse_remapped"), found.at("rmse"));
        EXPECT_GE(found.at("samples_asked"), 2);  // one sample is too few for any of them
    }
    for (std::size_t i = 11; i < 17; ++i) {
        const json own = result_of(document, i, "as it is");
        const json wide = result_of(document, i, "radius doubled");
        const json more = result_of(document, i, "radius and samples doubled");
        EXPECT_EQ(own.at("rmse"), own.at("rmse_own_radius"));
        EXPECT_NE(wide.at("rmse"), wide.at("rmse_own_radius"));
        EXPECT_EQ(wide.at("samples_asked"), own.at("samples_asked"));
        EXPECT_EQ(double{more.at("samples_asked")}, 2.0 * double{own.at("samples_asked")});
    }
    EXPECT_THAT(read_file(page),
                HasSubstr("| relief | study-volumetric-performance | radius doubled | 12 |"));
    EXPECT_THAT(read_file(page), Not(HasSubstr("old")));
}

TEST_F(BenchExperiments, AFileOfOnesOwn) {
    const fs::path file = write("mine.json", R"({
      "about": "two methods", "sizes": ["48x27"], "rounds": 1,
      "cases": [{"scene": "corner", "target": 1e-6}],
      "candidates": [{"name": "gtao", "method": "gtao"}, {"name": "alchemy", "method": "alchemy"}],
      "tables": [{"select": ["SELECT [case] AS 'scene', at_most(ms, target, 2) AS 'ms'",
        "FROM result WHERE candidate = 'gtao'"]}]})");
    const json document = measured({file.string()});
    EXPECT_EQ(document.at("experiment"), "mine");
    EXPECT_GT(double{result_of(document, 0, "alchemy").at("ms")}, 0.0);
    EXPECT_TRUE(result_of(document, 0, "alchemy").at("rmse").is_null()) << "no rays, no error";
    EXPECT_THAT(out_, testing::ContainsRegex("\\| corner \\| [0-9.]+, at most 1e-06: missed \\|"));
    EXPECT_EQ(run_command({"bench", file.string(), "--fail-if-missed"}).status, 1);
}

}  // namespace gloam::test::bench_experiments_test
