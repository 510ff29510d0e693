// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "check/image_ends.hpp"
#include "check/question.hpp"

// The description of an equation in the catalogue. One call of equation<Signature>() holds all that the
// tests, the command line, the tables and the documentation need:
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
// `.promised = make_predicate<Signature>([](float x, ...) { return ...; })` limits the inputs for which the
// budget is promised; the codomain holds for all. Degenerate inputs, and images of exact 0 and 1, are added
// to those of every entry (check/degenerate.hpp, check/image_ends.hpp). `.scenarios` provides images for a
// function that reads images (catalogue/scenarios.hpp); its reference then takes (const check::ImageSet&,
// arguments...).
namespace gloam::catalogue {

// The description of an equation for people.
struct Description {
    std::string id;        // as in the paper or sheet, unique: "TSSAO-5", "TSSAO-14-uniform"
    std::string function;  // in GLSL, and in C++ in gloam::reference
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

// `question`: members that follow neither from the description nor from the reference.
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
