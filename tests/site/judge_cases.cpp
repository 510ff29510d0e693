// SPDX-License-Identifier: MIT
// judge_cases FILE: outputs for inputs of every equation, some of them wrong, and what the judge of the
// framework says of them, as a script for the page. The judge of the page must say the same.
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/image_files.hpp"
#include "catalogue/catalogue.hpp"
#include "check/prepared_check.hpp"
#include "check/run.hpp"
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "report/check_report.hpp"
#include "site/page_data.hpp"

namespace {

using gloam::check::Word;
using gloam::shader::Scalar;
using nlohmann::ordered_json;

constexpr std::size_t inputs = 64;

Word word_of(Scalar scalar, double value) {
    if (scalar == Scalar::float_) return gloam::check::to_word(static_cast<float>(value));
    return static_cast<Word>(static_cast<std::int64_t>(value));
}

enum class Faults { slight, gross };

// Mostly the result itself or a float beside it; with gross faults sometimes another float, or what is none.
Word spoiled(Scalar scalar, Word word, Faults faults, gloam::numeric::Random& random) {
    const bool gross = faults == Faults::gross;
    if (scalar != Scalar::float_) return gross && random.below(16) == 0 ? word ^ 1U : word;
    const auto value = gloam::check::from_word<float>(word);
    switch (gross ? random.below(16) : 7 + random.below(9)) {
        case 0:
            return gloam::check::to_word(value * 1.01F);
        case 1:
            return 0x7fc00000U;
        case 2:
            return gloam::check::to_word(std::copysign(INFINITY, value));
        case 3:
            return 0;
        case 4:
        case 5:
        case 6:
            return gloam::check::to_word(
                gloam::numeric::step(value, static_cast<int>(random.below(65)) - 32));
        case 7:
        case 8:
            return gloam::check::to_word(gloam::numeric::step(value, static_cast<int>(random.below(3)) - 1));
        default:
            return word;
    }
}

std::vector<Word> outputs_of(const gloam::check::Question& question,
                             const gloam::check::PreparedScenario& scenario, Faults faults,
                             gloam::numeric::Random& random) {
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    std::vector<Word> outputs;
    for (const gloam::check::Expectation& expectation : scenario.expectations) {
        const auto& want = expectation.wants.at(random.below(expectation.wants.size()));
        for (std::size_t i = 0; i < scalars.size(); ++i)
            outputs.push_back(spoiled(scalars[i], word_of(scalars[i], want[i]), faults, random));
    }
    return outputs;
}

ordered_json case_of(const gloam::check::Lab& lab, const gloam::catalogue::Entry& entry, Faults faults) {
    const gloam::check::Question& question = entry.question;
    const gloam::check::PreparedCheck prepared = gloam::check::prepare(lab, question, {.inputs = inputs});
    gloam::numeric::Random random(gloam::numeric::hash_of(question.name));
    gloam::check::Answer answer = gloam::check::empty_answer(question, gloam::check::Verdict::budget);
    ordered_json outputs = ordered_json::array();
    for (const gloam::check::PreparedScenario& scenario : prepared.scenarios) {
        const std::vector<Word> words = outputs_of(question, scenario, faults, random);
        answer.merge(gloam::check::judge(question, {.nan = false}, scenario.inputs, words, scenario.images,
                                         scenario.name));
        const auto* const bytes = reinterpret_cast<const unsigned char*>(words.data());
        outputs.push_back(gloam::base::deflated_base64({bytes, words.size() * sizeof(Word)}));
    }
    return {{"check", ordered_json::parse(gloam::site::check_json(entry.description, question, prepared))},
            {"outputs", std::move(outputs)},
            {"answer", ordered_json::parse(gloam::report::to_json(answer))}};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "judge_cases FILE\n";
        return 2;
    }
    const gloam::check::Lab lab(
        {.device = std::string(gloam::check::interpreter_name), .include_roots = {GLOAM_GLSL_DIR}});
    ordered_json cases = ordered_json::array();
    for (const gloam::catalogue::Entry& entry : gloam::catalogue::all_entries(GLOAM_GLSL_DIR)) {
        if (!entry.question.reference || entry.question.only_rules) continue;
        for (const Faults faults : {Faults::slight, Faults::gross})
            cases.push_back(case_of(lab, entry, faults));
    }
    std::ofstream(argv[1]) << "gloam.cases = " << cases.dump() << ";\n";
    return 0;
}
