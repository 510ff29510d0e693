// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "effect/methods.hpp"
#include "experiment/comparison.hpp"
#include "experiment/experiment.hpp"
#include "experiment/visits.hpp"

namespace gloam::experiment::experiment_file_test {

constexpr const char* whole = R"({
  "about": "a description", "sizes": ["64x36"], "frames": 4, "scored": 2, "rounds": 3, "rays": 64,
  "preset": "fast", "set": {"samples": 8, "history": true, "filter": "none"},
  "cases": [{"scene": "sky", "shown": [3, 1], "scored": 1, "target": 0.5, "candidates": ["run"]}],
  "candidates": [{"name": "run", "sequence": true}, {"name": "loop", "plain": "9x3+1"},
    {"name": "truth", "truth": true}],
  "tables": [{"name": "all", "each": "SELECT [case] FROM cases", "select": ["SELECT 1", ", '{}'"]}]})";

TEST(ExperimentFile, ReadsAllParts) {
    const Experiment read = read_experiment("mine.json", whole);
    EXPECT_EQ(read.layer.preset, "fast");
    EXPECT_EQ(read.layer.set.at(1), (std::pair<std::string, std::string>("history", "on")));
    EXPECT_EQ(read.cases.at(0).name, "sky");
    EXPECT_EQ(read.cases.at(0).shown, (std::vector<int>{3, 1}));
    EXPECT_EQ(read.candidates.at(1).layer.kind, Kind::plain);
    EXPECT_EQ(read.candidates.at(1).layer.plain.taps.slices, 9U);
    EXPECT_EQ(read.candidates.at(1).layer.plain.blurs, 1);
    EXPECT_EQ(read.candidates.at(2).layer.kind, Kind::truth);
    EXPECT_EQ(read.tables.at(0).each, "SELECT [case] FROM cases");
    EXPECT_THAT(read.tables.at(0).select, ElementsAre("SELECT 1", ", '{}'"));
    EXPECT_NO_THROW(require_consistent(read));
}

// The candidates that the experiment then has: NAME|GROUP|METHOD|PRESET, and their settings.
std::vector<std::string> chosen(Experiment what) {
    choose_candidates(what);
    std::vector<std::string> all;
    for (const auto& [name, group, layer] : what.candidates) {
        std::string& text =
            all.emplace_back(fmt::format("{}|{}|{}|{}", name, group, layer.method, layer.preset));
        if (layer.sequence == false) text += "|alone";
        for (const auto& [setting, value] : layer.set) text += fmt::format("|{}={}", setting, value);
    }
    return all;
}

// Each method with each count, then each preset; single frames before sequences, which are a mean over at
// least two frames.
TEST(ExperimentFile, AQueryStandsForCandidates) {
    const auto of = [](const CandidateQuery& query) { return chosen({.candidate_query = query}); };
    EXPECT_THAT(of({.methods = {"gtao", "sao"}, .presets = {"fast"}, .samples = {4, 8}, .sequence = false}),
                ElementsAre("gtao/4/single|gtao|gtao|tssao-paper|alone|samples=4|samples_converged=4",
                            "gtao/8/single|gtao|gtao|tssao-paper|alone|samples=8|samples_converged=8",
                            "sao/4/single|sao|sao|tssao-paper|alone|samples=4|samples_converged=4",
                            "sao/8/single|sao|sao|tssao-paper|alone|samples=8|samples_converged=8",
                            "fast/12/single|presets||fast|alone"));
    EXPECT_THAT(of({.presets = {"fast"}, .single = false}), ElementsAre("fast/12/temporal|presets||fast"));
    EXPECT_THAT(of({.methods = {"hemisphere"}, .samples = {512}, .single = false}),
                ElementsAre("hemisphere/512/temporal|hemisphere, temporal|hemisphere|tssao-paper|samples=512"
                            "|samples_converged=512|weight_max=1024"));
    EXPECT_EQ(of({.samples = {4}}).size(), 2 * effect::methods().size());
    for (const CandidateQuery& query :
         {CandidateQuery{.presets = {"magic"}}, {.methods = {"magic"}}, {.single = false, .sequence = false}})
        EXPECT_THROW((void)of(query), std::invalid_argument);
}

// Without counts each method is as it is, with its preset, behind the candidates of the list.
TEST(ExperimentFile, AQueryWithoutCountsTakesMethodsAsTheyAre) {
    const char* const both = R"({"name": "loop", "plain": "9x3+1"},
    {"name": "truth", "truth": true})";
    const std::string text = with(whole, both, R"({"methods": ["gtao", "crytek", "unreal"]})");
    EXPECT_THAT(chosen(read_experiment("mine.json", text)),
                ElementsAre("run|||", "gtao|methods|gtao|", "crytek|methods|crytek|",
                            "study-crytek-quality|methods||study-crytek-quality", "unreal|methods|unreal|",
                            "unreal-quality|methods||unreal-quality"));
}

// A part of the description, what stands there instead, and what is said of it.
struct Fault {
    const char* part;
    const char* other;
    const char* why;
};
constexpr Fault misread[] = {
    {"\"rays\"", "\"rayz\"", "rayz: expected one of"},
    {"\"sizes\": [\"64x36\"]", "\"sizes\": []", "sizes"},
    {"\"frames\": 4", "\"frames\": 1e9", "frames: expected a whole number from 1 to 1000"},
    {"\"rounds\": 3", "\"rounds\": -1", "rounds"},
    {"\"rounds\": 3", "\"rounds\": 2.5", "rounds"},
    {"\"scene\": \"sky\"", "\"scene\": 3", "cases[0].scene: expected a text"},
    {"[3, 1]", "[3, 0]", "cases[0].shown[1]"},
    {"\"target\": 0.5", "\"target\": \"big\"", "cases[0].target: expected a number"},
    {"9x3+1", "9x", "candidates[1].plain: expected SLICESxSTEPS+BLURS"},
    {"\"select\"", "\"columns\"", "tables[0]: expected an object with \"select\""},
    {"\"SELECT 1\"", "1", "tables[0].select[0]: expected a text"},
    {"{\"samples\": 8", "{\"samples\": [8]", "set.samples"},
    {"\"name\": \"run\", ", "", "candidates[0]: expected an object with \"name\""},
    {"\"sequence\": true", "\"enough_samples\": 1", "candidates[0].enough_samples: expected true or false"},
    {"\"sequence\": true", "\"pictures\": [\"all\"]",
     "candidates[0].pictures[0]: expected one of visibility, error"},
    {"\"sequence\": true}", "\"sequence\": true}, {\"methods\": []}, {\"methods\": []}",
     "candidates[2]: expected one query alone"},
    {"\"scored\": 1", "\"every\": 0", "cases[0].every: expected a whole number from 1"},
    {"\"name\": \"all\"", "\"measures\": [\"all\"]",
     "tables[0].measures[0]: expected one of depth, remapped"},
};
// Names that parts refer to exist, and once.
constexpr Fault inconsistent[] = {
    {"SELECT 1", "SELECT candidate = 'lop'", "\"lop\""},
    {"SELECT 1", "SELECT one", "mine.json: tables[0]: no such column: one"},
    {"SELECT [case]", "DELETE", "tables[0]: "},
    {"SELECT 1", "SELECT (SELECT rmse_fit FROM result)",
     "a table: no such column: rmse_fit, expected in its"},
    {"SELECT 1", "SELECT (SELECT 1 FROM class_errors)", "no such table: class_errors"},
    {"[\"run\"]", "[\"ran\"]", "\"ran\""},
    {"\"name\": \"loop\"", "\"name\": \"run\"", "twice"},
};

TEST(ExperimentFile, EveryFaultIsNamedWithItsPlace) {
    const auto expect_refused = [](const std::string& text, const std::string& why) {
        expect_error<std::runtime_error>([&] { (void)read_experiment("mine.json", text); },
                                         {"mine.json", why});
    };
    expect_refused("", "no JSON");
    expect_refused("[]", "an object");
    expect_refused(std::string(100'000, '['), "nested");
    for (const Fault& fault : misread) expect_refused(with(whole, fault.part, fault.other), fault.why);
    for (const Fault& fault : inconsistent) {
        const Experiment read = read_experiment("mine.json", with(whole, fault.part, fault.other));
        expect_error<std::invalid_argument>([&] { require_consistent(read); }, {fault.why});
    }
    // What is not read may be called so.
    EXPECT_NO_THROW(require_consistent(read_experiment(
        "mine.json", with(whole, "SELECT 1", "SELECT (SELECT 1 AS 'rmse_fit' FROM result)"))));
}

// Bytes of a description that are changed at random give a description or one line.
TEST(ExperimentFile, DamagedFilesAreRefusedOrRead) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        std::string text = whole;
        for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(random());
        try {
            (void)read_experiment("mine.json", text);
        } catch (const std::runtime_error&) {
        }
    }
}

// Comparisons of results, and questions to them.

const std::vector<Row> two_scenes{{"a", "fast", 10, 0.08}, {"a", "good", 40, 0.02}, {"a", "bad", 50, 0.09},
                                  {"b", "fast", 10, 0.04}, {"b", "good", 90, 0.04}, {"b", "bad", 50, 0.05}};

TEST(ExperimentChoices, NameTheBestWithinAndTheFastestWith) {
    const Record record = make_record(two_scenes);
    const auto expect = [&](const char* budget, double error, const std::string& answer) {
        EXPECT_THAT(answers_to(Database(record), budget, error).text, HasSubstr(answer));
        EXPECT_EQ(answers_to(Database(record), budget, error).all, answer.find("no configuration") > 99);
    };
    expect("95ms", 0, "within 95ms: good, at most 90.000 ms, RMSE (G) 0.0300 in the mean, at most 0.0400\n");
    expect("89ms", 0, "within 89ms: fast, ");  // 90 in one case
    expect("9ms", 0, "within 9ms: no configuration\n  the nearest: fast, at most 10.000 ms");
    expect("", 0.08, "RMSE at most 0.08: fast, ");
    expect("", 0.07, "RMSE at most 0.07: good, ");
    expect("", 0.03, "RMSE at most 0.03: no configuration\n  the nearest: good, ");  // 0.04 in one case
    EXPECT_EQ(answers_to(Database(record), "", 0).text, "");
}

Comparison changed(const std::vector<Row>& before, const std::vector<Row>& after) {
    return compared(make_record(before), make_record(after));
}

// 10.8 to 13.2 after 9 to 11 is within the spread.
TEST(ExperimentComparison, ATimeChangesBeyondItsSpread) {
    const Comparison found = changed({{"a", "m", 10, 0.05}, {"a", "n", 10, 0.05}, {"a", "o", 10, 0.05}},
                                     {{"a", "m", 12, 0.05}, {"a", "n", 13, 0.05}, {"a", "o", 8, 0.05}});
    EXPECT_TRUE(found.got_worse);
    const std::string name = std::string(44 - 3, ' ');
    EXPECT_EQ(found.text,
              "3 configurations in both; new over old, geometric means: time 1.077, error 1.000\n"
              "slower, beyond the spread: 1\n  a/n" +
                  name +
                  " time 1.300 (1.064 to 1.589)   error 1.000\n"
                  "faster, beyond the spread: 1\n  a/o" +
                  name + " time 0.800 (0.655 to 0.978)   error 1.000\n");
}

TEST(ExperimentComparison, WarnsOfOtherCircumstancesAndStillCompares) {
    const Record before = make_record({{"a", "m/4", 10, 0.05}, {"a", "old/4", 1, 1}});
    Conditions others = before.conditions();
    others.device = "another";
    others.rays = 64;
    Record after(others);
    for (const int round : {0, 1}) {
        for (const char* name : {"m/4", "new/4"}) {
            Visit visit = make_visit("a", name, round, 20, 0.05);
            visit.size = {640, 180};
            after.add(visit);
        }
    }
    const Comparison found = compared(before, after);
    EXPECT_THAT(found.text, StartsWith("warning: other devices: device"));
    for (const char* text :
         {"other sizes: 320 x 180 and 640 x 180\n", "256 rays", "1 configurations in both", "time 2.000",
          "only in the old file: 1, the first a/old/4\n", "only in the new file: 1, the first a/new/4\n"})
        EXPECT_THAT(found.text, HasSubstr(text));
}

}  // namespace gloam::experiment::experiment_file_test
