// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <random>

#include "effect/methods.hpp"
#include "experiment/experiment.hpp"

namespace gloam::experiment {
namespace experiment_file_test {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* whole = R"({
  "about": "a description", "sizes": ["64x36"], "frames": 4, "scored": 2, "rounds": 3, "rays": 64,
  "preset": "fast", "set": {"samples": 8, "freeze": true, "filter": "none"},
  "cases": [{"scene": "sky", "shown": [3, 1], "scored": 1, "target": 0.5, "candidates": ["run"]}],
  "candidates": [{"name": "run", "sequence": true}, {"name": "loop", "plain": "9x3+1"}],
  "tables": [{"rows": "cases", "columns": [{"title": "ratio", "value": "ms", "of": "run", "over": "loop"}]}]})";

// The description with a part replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string text = whole;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

void expect_refused(const std::string& text, const std::string& why) {
    EXPECT_THAT([&] { (void)read_experiment("mine.json", text); },
                testing::ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("mine.json"), HasSubstr(why))));
}

TEST(ExperimentFile, ReadsAllParts) {
    const Experiment read = read_experiment("mine.json", whole);
    EXPECT_EQ(read.layer.preset, "fast");
    EXPECT_EQ(read.layer.set.at(1), (std::pair<std::string, std::string>("freeze", "on")));
    EXPECT_EQ(read.cases.at(0).name, "sky");
    EXPECT_EQ(read.cases.at(0).shown, (std::vector<int>{3, 1}));
    EXPECT_EQ(read.candidates.at(1).layer.kind, Kind::plain);
    EXPECT_EQ(read.candidates.at(1).layer.plain.taps.slices, 9U);
    EXPECT_EQ(read.candidates.at(1).layer.plain.blurs, 1);
    EXPECT_EQ(read.tables.at(0).columns.at(0).over, "loop");
    EXPECT_NO_THROW(require_consistent(read));
}

// Each method with each count, then each preset; single frames before sequences.
TEST(ExperimentFile, AQueryStandsForCandidates) {
    const auto names_of = [](CandidateQuery query) {
        Experiment what;
        what.candidate_query = std::move(query);
        choose_candidates(what);
        std::vector<std::string> names;
        for (const Candidate& candidate : what.candidates) names.push_back(candidate.name);
        return names;
    };
    EXPECT_THAT(
        names_of({.methods = {"gtao", "sao"}, .presets = {"fast"}, .samples = {4, 8}, .sequence = false}),
        testing::ElementsAre("gtao/4/single", "gtao/8/single", "sao/4/single", "sao/8/single",
                             "fast/12/single"));
    EXPECT_THAT(names_of({.presets = {"fast"}, .single = false}), testing::ElementsAre("fast/12/temporal"));
    EXPECT_EQ(names_of({.samples = {4}}).size(), 2 * effect::methods().size());
    EXPECT_THROW((void)names_of({.presets = {"magic"}}), std::invalid_argument);
    EXPECT_THROW((void)names_of({.methods = {"magic"}}), std::invalid_argument);
    EXPECT_THROW((void)names_of({.single = false, .sequence = false}), std::invalid_argument);
}

// Without counts each method is as it is, with its preset.
TEST(ExperimentFile, AQueryWithoutCountsTakesMethodsAsTheyAre) {
    Experiment what = read_experiment("mine.json", with("{\"name\": \"loop\", \"plain\": \"9x3+1\"}",
                                                        "{\"methods\": [\"gtao\", \"crytek\", \"unreal\"]}"));
    choose_candidates(what);
    ASSERT_EQ(what.candidates.size(), 6U);
    EXPECT_EQ(what.candidates[0].name, "run");
    EXPECT_EQ(what.candidates[1].name, "gtao");
    EXPECT_EQ(what.candidates[1].group, "methods");
    EXPECT_EQ(what.candidates[1].layer.method, "gtao");
    EXPECT_EQ(what.candidates[3].name, "study-crytek-quality");
    EXPECT_EQ(what.candidates[3].layer.preset, "study-crytek-quality");
    EXPECT_EQ(what.candidates[5].name, "unreal-quality");
    EXPECT_EQ(what.candidates[5].group, "methods");
}

// A mean over at least two frames.
TEST(ExperimentFile, AMethodTakesTheSamplesAskedFor) {
    Experiment what;
    what.candidate_query = {.methods = {"hemisphere"}, .samples = {512}};
    choose_candidates(what);
    const Candidate& single = what.candidates.at(0);
    EXPECT_EQ(single.layer.preset, "tssao-paper");
    EXPECT_EQ(single.layer.sequence, false);
    using testing::Pair;
    EXPECT_THAT(single.layer.set,
                testing::ElementsAre(Pair("samples", "512"), Pair("samples_converged", "512")));
    const Candidate& sequence = what.candidates.at(1);
    EXPECT_EQ(sequence.group, "hemisphere, temporal");
    EXPECT_EQ(sequence.layer.preset, "balanced");
    EXPECT_EQ(sequence.layer.set.back(), (std::pair<std::string, std::string>("weight_max", "1024")));
}

TEST(ExperimentFile, EveryFaultIsNamedWithItsPlace) {
    expect_refused("", "no JSON");
    expect_refused("[]", "an object");
    expect_refused(std::string(100'000, '['), "nested");
    expect_refused(with("\"rays\"", "\"rayz\""), "rayz: expected one of");
    expect_refused(with("\"sizes\": [\"64x36\"]", "\"sizes\": []"), "sizes");
    expect_refused(with("\"frames\": 4", "\"frames\": 1e9"),
                   "frames: expected a whole number from 1 to 1000");
    expect_refused(with("\"rounds\": 3", "\"rounds\": -1"), "rounds");
    expect_refused(with("\"rounds\": 3", "\"rounds\": 2.5"), "rounds");
    expect_refused(with("\"scene\": \"sky\"", "\"scene\": 3"), "cases[0].scene: expected a text");
    expect_refused(with("[3, 1]", "[3, 0]"), "cases[0].shown[1]");
    expect_refused(with("\"target\": 0.5", "\"target\": \"big\""), "cases[0].target: expected a number");
    expect_refused(with("\"over\": \"loop\"", "\"over_case\": \"ski\""), "over_case: \"ski\"");
    expect_refused(with("9x3+1", "9x"), "candidates[1].plain: expected SLICESxSTEPS+BLURS");
    expect_refused(with("\"value\": \"ms\"", "\"value\": \"luck\""), "tables[0].columns[0].value");
    expect_refused(with("{\"samples\": 8", "{\"samples\": [8]"), "set.samples");
    expect_refused(with("\"name\": \"run\", ", ""), "candidates[0]: expected an object with \"name\"");
    expect_refused(with("\"sequence\": true", "\"held\": 1"), "candidates[0].held: expected true or false");
    expect_refused(with("\"sequence\": true", "\"pictures\": [\"all\"]"),
                   "candidates[0].pictures[0]: expected one of visibility, error");
    expect_refused(with("\"sequence\": true}", "\"sequence\": true}, {\"methods\": []}, {\"methods\": []}"),
                   "candidates[2]: expected one query alone");
    expect_refused(with("\"scored\": 1", "\"every\": 0"), "cases[0].every: expected a whole number from 1");
    expect_refused(with("\"scored\": 1", "\"pixels\": 64"), "cases[0].pixels: expected an odd number");
}

TEST(ExperimentFile, AColumnAsksForWhatThereIs) {
    const std::string place = "tables[0].columns[0]";
    const auto refused = [&](const std::string& column, const std::string& why) {
        expect_refused(with("\"value\": \"ms\"", column), place + why);
    };
    refused(R"("value": "rmse", "pixels": "odd")", ".pixels: expected one of all, settled");
    refused(R"("value": "rmse", "against": "me")", ".against: expected one of limit, depth, geometry");
    refused(R"("value": "ms", "against": "limit")", ": expected a \"value\" of rmse, rmse_raw");
    refused(R"("value": "copies", "statistic": "slope")", ": expected a \"value\" of rmse, rmse_raw");
    refused(R"("value": "rmse", "frame": 0)", ".frame: expected a whole number from 1");
    refused(R"("value": "rmse", "most": "little")", ".most: expected a number");
    refused(R"("value": "rmse", "beside": "luck")", ".beside: expected one of ms");
    refused(R"("value": "rmse", "repeated": "cakes")", ".repeated: expected one of candidates, cases");
    expect_refused(with("\"over\": \"loop\"", "\"cases\": [\"ski\"]"), "cases: \"ski\"");
    expect_refused(with("\"rows\": \"cases\"", "\"rows\": \"cases\", \"keep\": \"some\""),
                   "tables[0].keep: expected one of front, best, doubling");
}

TEST(ExperimentFile, NamesThatPartsReferToExistOnce) {
    const auto expect = [](const std::string& text, const std::string& why) {
        const Experiment read = read_experiment("mine.json", text);
        EXPECT_THAT([&] { require_consistent(read); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
    };
    expect(with("\"over\": \"loop\"", "\"over\": \"lop\""), "\"lop\"");
    expect(with("[\"run\"]", "[\"ran\"]"), "\"ran\"");
    expect(with("\"name\": \"loop\"", "\"name\": \"run\""), "twice");
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

TEST(PlainLoop, IsReadFromSlicesStepsAndBlurs) {
    EXPECT_EQ(plain_loop("64x3").blurs, 0);
    EXPECT_EQ(plain_loop("1x2+9").blurs, 9);
    for (const char* text : {"", "x", "9", "9x", "x3", "0x3", "9x65", "9x3+", "9x3+10", "9x3+a", "9+1",
                             "-1x3", "9x3x1", "99999999999x1"})
        EXPECT_THROW((void)plain_loop(text), std::invalid_argument) << text;
}

TEST(Cases, AQueryIsReplacedByItsCases) {
    Experiment views{.query = CaseQuery{.views = true, .half = "unseen"}};
    choose_cases(views, {"room", "moving"}, "", "");
    ASSERT_EQ(views.cases.size(), 1U);  // moving is of the other half
    EXPECT_EQ(views.cases[0].half, "unseen");
    Experiment scenes{.query = CaseQuery{}};
    choose_cases(scenes, {}, "", "");
    EXPECT_GT(scenes.cases.size(), 3U);
    EXPECT_THROW(choose_cases(scenes, {"magic"}, "", ""), std::invalid_argument);
    EXPECT_THROW(choose_cases(scenes, {}, "unseen", ""), std::invalid_argument);
}

}  // namespace experiment_file_test
}  // namespace gloam::experiment
