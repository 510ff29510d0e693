// SPDX-License-Identifier: MIT
// Wrong results, planted behind the back of a device: the check of every equation notices them by the rules
// alone, and by its reference where the device promises least. What is noticed there is noticed on every
// other device.
#include "backend/gl/device.hpp"
#include "judge/run.hpp"
#include "judge/session.hpp"
#include "support/entries.hpp"
#include "support/lab.hpp"
#include "support/test_name.hpp"

namespace gloam::judge::planted_test {

using namespace subject;

using catalogue::Entry;

// A few inputs are enough for most equations; the others get more.
constexpr std::array<std::size_t, 3> inputs_tried{48, 512, 4096};
constexpr std::size_t shards = 6;

struct Plant {
    std::string_view name;
    void (*into)(std::vector<Word>& outputs);
};
constexpr std::array plants{
    Plant{"42", [](std::vector<Word>& outputs) { std::ranges::fill(outputs, to_word(42.0F)); }},
    Plant{"zero", [](std::vector<Word>& outputs) { std::ranges::fill(outputs, Word{0}); }},
    // Each word moves by one place: to the next output, or to the next input.
    Plant{"swapped", [](std::vector<Word>& outputs) { std::ranges::rotate(outputs, outputs.begin() + 1); }}};

// Plants that are the right results: of functions that always return the same.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> right_anyway{
    {{"MOMENTS-empty", "zero"}, {"MOMENTS-empty", "swapped"}, {"BACKGROUND-depth", "swapped"}}};

// A probe asks which of several right results a device gives. Zero is one of them, and may be its only one.
bool is_wrong(const Plant& plant, const Question& question) {
    if (question.file == "builtin/probe.glsl") return plant.name == plants.front().name;
    return std::ranges::find(right_anyway, std::pair(std::string_view(question.name), plant.name)) ==
           right_anyway.end();
}

// What is said of the right results and of each plant.
struct Verdicts {
    Answer right;
    std::array<Answer, plants.size()> planted;

    explicit Verdicts(const Answer& empty) : right(empty) { planted.fill(empty); }
    // `judge` adds what it says of some outputs to an answer.
    template <class Judge>
    void add(const std::vector<Word>& outputs, Judge judge) {
        judge(outputs, right);
        for (std::size_t i = 0; i < plants.size(); ++i) {
            if (planted[i].failed()) continue;
            std::vector<Word> wrong = outputs;
            plants[i].into(wrong);
            judge(wrong, planted[i]);
        }
    }
};

// Tries more inputs until every plant is noticed.
template <class Evaluate>
void expect_noticed(const Entry& entry, Evaluate evaluate) {
    for (const std::size_t inputs : inputs_tried) {
        const Verdicts verdicts = evaluate(inputs);
        EXPECT_FALSE(verdicts.right.failed()) << entry.description.id << ": " << verdicts.right;
        if (verdicts.right.outcome() == Outcome::not_judged) return;
        std::string unnoticed;
        for (std::size_t i = 0; i < plants.size(); ++i)
            if (is_wrong(plants[i], entry.question) && !verdicts.planted[i].failed())
                unnoticed.append(" ").append(plants[i].name);
        if (unnoticed.empty()) return;
        EXPECT_NE(inputs, inputs_tried.back()) << entry.description.id << " passes with" << unnoticed;
    }
}

Verdicts verdicts_on(const Lab& lab, const KernelCore& kernel, const Question& question, std::size_t inputs) {
    Verdicts verdicts(empty_answer(question, question.criterion_in(lab.options().variant)));
    for (const auto& [scenario, share] : question.shares(inputs)) {
        const Session session(lab, question, kernel, scenario, 1);
        auto evaluated =
            session.run(question.domain.draw(share, session.input_seed(), scenario.size), verdicts.right);
        verdicts.add(evaluated.result.outputs, [&](const std::vector<Word>& outputs, Answer& answer) {
            auto as_given = evaluated;
            as_given.result.outputs = outputs;
            session.judge(as_given, answer);
        });
    }
    return verdicts;
}

// Kernels compile in every version, but for wrappers of built-ins and probes.
void expect_noticed_on(const Lab& lab, const Entry& entry) {
    const Question& question = entry.question;
    try {
        const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
        expect_noticed(entry, [&](std::size_t inputs) { return verdicts_on(lab, kernel, question, inputs); });
    } catch (const backend::Unsupported& error) {
        EXPECT_TRUE(entry.description.file.starts_with("builtin/")) << entry.description.id << error.what();
    }
}

// One of so many parts of the catalogue, in a variant on Vulkan or on an OpenGL device.
class Planted : public testing::TestWithParam<std::tuple<const char*, std::size_t>> {
  protected:
    static Lab lab_on(const std::string& where) {
        if (!backend::gl::device_name_from(where)) return test::make_lab({}, module::variant(where));
        return Lab(
            {.device = where, .include_roots = {GLOAM_GLSL_DIR}, .cache_directory = test::cache_directory()});
    }
};

TEST_P(Planted, FailsForEveryEquationThatIsJudged) {
    std::optional<Lab> lab;
    try {
        lab.emplace(lab_on(std::get<0>(GetParam())));
    } catch (const backend::gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    for (std::size_t i = std::get<1>(GetParam()); i < test::entries().size(); i += shards)
        expect_noticed_on(*lab, test::entries()[i]);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Planted,
                         testing::Combine(testing::Values("strict", "es:llvmpipe-3.0"),
                                          testing::Range(std::size_t{0}, shards)),
                         [](const auto& info) {
                             return test::test_name(std::get<0>(info.param)) + "_" +
                                    std::to_string(std::get<1>(info.param));
                         });

}  // namespace gloam::judge::planted_test
