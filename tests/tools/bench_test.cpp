// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::bench_test {

// Two methods at two counts, as small as images may be useful.
Arguments tiny(const Arguments& more) {
    Arguments arguments = words(
        "bench --scene moving --method hemisphere gtao --samples 4 16 --size 64x36 "
        "--frames 4 --rays 32 --repeat 1");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// A configuration of a case, as --json has it.
void expect_plausible(const json& row) {
    const bool temporal = row.at("candidate").get<std::string>().ends_with("temporal");
    EXPECT_GT(double{row.at("ms")}, 0.0);
    EXPECT_GT(double{row.at("rmse")}, 0.0);
    EXPECT_LT(double{row.at("rmse")}, 0.3);
    EXPECT_GT(double{row.at("rmse_depth")}, 0.0);
    const double taken = row.at("samples");
    EXPECT_GT(taken, 0.0);
    // Fewer where nothing can block, but one slice at least.
    constexpr double slice = 8.0;
    EXPECT_LE(taken, std::max(double{row.at("samples_asked")}, slice) + 1e-9);
    EXPECT_GT(double{row.at("memory_mib")}, 64.0 * 36.0 * 4.0 * 10.0 / 1048576.0);
    EXPECT_EQ(row.at("flicker").is_number(), temporal);
}

json results_in(const fs::path& file) {
    return json::parse(read_file(file)).at("results");
}

void expect_compared(const fs::path& file, const fs::path& second) {
    const CommandResult comparison = run_command({"bench", "--compare", file.string(), second.string()});
    expect_success(comparison);
    EXPECT_THAT(comparison.out, HasSubstr("8 configurations in both"));
    EXPECT_THAT(comparison.out, HasSubstr("error 1.000"));
}

void expect_answered(const fs::path& file) {
    const CommandResult answered =
        run_command({"bench", "--from", file.string(), "--budget", "1000000ms", "--error", "0.3"});
    expect_success(answered);
    EXPECT_THAT(answered.out, HasSubstr("within 1000000ms: "));
    EXPECT_THAT(answered.out, HasSubstr("RMSE at most 0.3: "));
    const CommandResult none = run_command({"bench", "--from", file.string(), "--error", "0.000001"});
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.out, HasSubstr("no configuration"));
}

using Bench = InFolder;

TEST_F(Bench, MeasuresResumesAnswersAndCompares) {
    const auto out = folder.path() / "out";
    const auto file = folder.path() / "a.json";
    const CommandResult first =
        run_command(tiny({"--validation", "--out", out.string(), "--json", file.string()}));
    expect_success(first);
    EXPECT_THAT(first.out, HasSubstr("all scenes"));
    const json results = results_in(file);
    ASSERT_EQ(results.size(), 8U);
    for (const json& row : results) {
        SCOPED_TRACE(row.dump());
        expect_plausible(row);
    }
    EXPECT_EQ(read_file(out / "results.json"), read_file(file));
    EXPECT_EQ(line_count(read_file(out / "results.csv")), 1 + 8);

    for (const char* kept : {"journal.jsonl", "results.json"})
        EXPECT_EQ(output_of(gloam("bench --from {}", out / kept)), first.out) << kept;

    // Interrupted in the middle of a line, and taken up again.
    const std::string journal = read_file(out / "journal.jsonl");
    ASSERT_EQ(line_count(journal), 1 + 8 + 4);  // the second round visits single frames only
    std::ofstream(out / "journal.jsonl") << journal.substr(0, journal.size() / 2);
    const auto second = folder.path() / "b.json";
    expect_success(run_command(tiny({"--resume", "--out", out.string(), "--json", second.string()})));
    EXPECT_EQ(line_count(read_file(out / "journal.jsonl")), line_count(journal));
    const json again = results_in(second);
    ASSERT_EQ(again.size(), results.size());
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const char* error : {"rmse", "rmse_raw", "rmse_depth", "similarity", "flicker", "samples"})
            EXPECT_EQ(again[i].at(error), results[i].at(error)) << error;  // the same to the bit
    expect_could_not_run(
        gloam("bench --scene moving --preset fast --frames 2 --rays 32 --resume --out {}", out),
        "cannot resume");

    expect_compared(file, second);
    expect_answered(file);
}

// A result file changed by hand: errors that rise are found, and another device is no obstacle.
TEST_F(Bench, ComparesWithWhatGotWorse) {
    const auto file = folder.path() / "a.json";
    const auto worse = folder.path() / "b.json";
    const auto page = folder.path() / "page.md";
    expect_success(
        gloam("bench --scene corner --preset fast --size 32x18 --frames 2 --rays 32 --repeat 1 "
              "--single --json {} --report {}",
              file, page));
    EXPECT_THAT(read_file(page), HasSubstr("| fast/12/single |"));
    EXPECT_THAT(read_file(page), HasSubstr("all scenes, presets"));
    json document = json::parse(read_file(file));
    document["device"] = "another";
    json& error = document["visits"][0]["quality"]["rmse"];
    error = double{error} + 0.01;
    std::ofstream(worse) << document.dump();
    const CommandResult told = run_command({"bench", "--compare", file.string(), worse.string()});
    expect_success(told);
    EXPECT_THAT(told.out, HasSubstr("warning: other devices"));
    EXPECT_THAT(told.out, HasSubstr("larger error: 1\n  corner/fast/12/single"));
    const CommandResult failed =
        run_command({"bench", "--compare", file.string(), worse.string(), "--fail-if-worse"});
    EXPECT_EQ(failed.status, 1);
    expect_success(run_command({"bench", "--compare", worse.string(), worse.string(), "--fail-if-worse"}));
}

fs::path page_with(const fs::path& folder, const Arguments& blocks) {
    std::ofstream page(folder / "methods.md");
    for (const std::string& name : blocks)
        page << "before " << name << "\n<!-- begin " << name << " -->\nold\n<!-- end " << name << " -->\n";
    return folder / "methods.md";
}

void expect_plausible(const json& point, const std::string& candidate) {
    EXPECT_EQ(double{point.at("truth")}, 0.0);
    if (candidate == "truth") return;
    const double open = candidate.find("volumetric") != std::string::npos ? 0.5 : 0.0;
    EXPECT_NEAR(double{point.at("occlusion")}, open, 1e-5) << candidate;
}

TEST(BenchMethods, WritesTablesPicturesAndNumbers) {
    const TemporaryDirectory folder;
    const auto page = page_with(folder.path(), {"views", "bias", "scenes"});
    const auto file = folder.path() / "methods.json";
    const auto out = folder.path() / "pictures";
    const CommandResult result = gloam(
        "bench methods --case corner {} {} --method gtao volumetric --size 32x18 --rays 32 --frames 4 "
        "--rounds 1 --validation --json {} --out {} --page {}",
        "plane 0", "wall 0.25", file, out, page);
    expect_success(result);
    const std::string text = read_file(page);
    EXPECT_THAT(text, Not(HasSubstr("old")));
    EXPECT_THAT(text, HasSubstr("| configuration, occlusion | planes | wall 0.25 |"));
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

TEST(BenchMethods, APageWithoutABlockStaysAsItIs) {
    const TemporaryDirectory folder;
    const auto page = page_with(folder.path(), {"views", "bias"});
    const std::string before = read_file(page);
    expect_could_not_run(gloam("bench methods --page {}", page), "begin scenes");
    EXPECT_EQ(read_file(page), before);
}

Arguments temporal(const Arguments& more) {
    Arguments arguments = words(
        "bench temporal --case moving {} --size 32x18 --frames 9 --scored 5 --rays 32 "
        "--validation",
        "moving, still");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchTemporal, WritesWhatItMeasured) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "temporal.json";
    const auto out = folder.path() / "out";
    const CommandResult result = run_command(temporal({"--json", file.string(), "--out", out.string()}));
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| moving | neighbourhood (9) off: the history counts in full | 0."));
    EXPECT_THAT(result.out, HasSubstr("| moving, still | 16 | "));
    EXPECT_THAT(result.out, HasSubstr(", at most 0.01: "));
    for (const char* kind : {"visibility", "error", "convergence", "samples", "limit"})
        EXPECT_THAT(read_file(out / (std::string("moving-full-") + kind + ".png")), HasSubstr("PNG"));
    const json document = json::parse(read_file(file));
    std::size_t sequences = 0;
    for (const json& visit : document.at("visits")) {
        const json& scores = visit.at("quality").at("by_class");
        const bool still = visit.at("case") == "moving, still";
        ASSERT_EQ(scores.at("frames").size(), still ? 32U : 2U) << visit.at("candidate");
        EXPECT_EQ(scores.at("frames").back().at("frame"), still ? 32 : 9);
        for (const json& frame : scores.at("frames")) {
            const json& first = frame.at("classes").at(0);
            EXPECT_EQ(first.at("pixels"), "all");
            EXPECT_EQ(first.at("against"), "limit");
            EXPECT_GT(first.at("raw_squares"), 0.0) << visit.at("candidate");
        }
        sequences += scores.at("flicker").empty() ? 0 : 1;
    }
    EXPECT_EQ(sequences, 17U) << "but for single frames and what stands still";

    // The same tables from the journal, with the pictures that were drawn before.
    const CommandResult again = run_command(temporal({"--resume", "--out", out.string()}));
    expect_success(again);
    EXPECT_EQ(again.out, result.out);
    EXPECT_THAT(read_file(out / "moving-full-error.png"), HasSubstr("PNG"));
}

}  // namespace gloam::test::bench_test
