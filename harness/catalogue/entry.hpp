// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "check/image_ends.hpp"
#include "check/question.hpp"

// How an equation enters the catalogue. One call of equation<Signature>() holds all that the tests, the
// command line, the tables and the documentation know of it:
//
//     entries.push_back(equation<glm::vec2(float, float, float, float, float)>(
//         {.id = "TSSAO-5",
//          .function = "gloam_blend",
//          .file = "gloam/temporal/blend.glsl",
//          .title = "blend of the history with new samples",
//          .formula = "AO + (C - AO) k / (w + k);  w' = min(w + k, w_max)",
//          .source = "TSSAO (Mattausch et al.), eqs 4 and 5"},
//         &reference::gloam_blend,
//         {.domain = {uniform(0, 1).and_special(), ...},     // one Values for each in or inout parameter
//          .budget = {.ulp = 3},                             // measured; see check::Budget
//          .codomain = {0, 1e9}}));                          // holds for every input whatever, NaN included
//
// `.promised = make_predicate<Signature>([](float x, ...) { return ...; })` limits where the budget is
// promised; the codomain holds everywhere. Degenerate inputs and images of exact 0 and 1 are added to every
// entry's own (check/degenerate.hpp, check/image_ends.hpp). `.scenarios` gives images to a function that
// reads some (catalogue/scenarios.hpp); its reference then takes (const check::ImageSet&, arguments...).
namespace gloam::catalogue {

// What people read about an equation.
struct Description {
    std::string id;        // as in the paper or sheet, unique: "TSSAO-5", "TSSAO-14-uniform"
    std::string function;  // GLSL, and C++ in gloam::reference
    std::string file;      // as in #include "gloam/..."
    std::string title;     // a few words
    std::string formula;   // plain text mathematics
    std::string source;    // paper, equation number
};

struct Entry {
    Description description;
    check::Question question;
};

using Entries = std::vector<Entry>;

// `question`: what is not said by the other two.
template <class Signature, class Reference>
[[nodiscard]] Entry equation(Description description, Reference reference, check::Question question) {
    question.name = description.id;
    question.file = description.file;
    question.function = description.function;
    question.signature = check::SignatureOf<Signature>::describe();
    question.domain = question.domain.and_degenerate(question.signature);
    question.reference = check::make_reference<Signature>(reference);
    question.scenarios = with_exact_ends(std::move(question.scenarios));
    return {.description = std::move(description), .question = std::move(question)};
}

}  // namespace gloam::catalogue
