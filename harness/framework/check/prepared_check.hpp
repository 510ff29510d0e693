// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/answer.hpp"
#include "check/lab.hpp"
#include "check/question.hpp"
#include "check/run.hpp"

namespace gloam::check {

// How the result for one input is judged.
enum class Criterion {
    recorded,  // it is not: the input or the exact result contains NaN or infinity
    codomain,  // no accuracy is promised: the outputs must be inside the codomain
    budget,    // the codomain, and the budget around one of Expectation::wants
    edge       // the codomain, and the documented result for zero near one of Expectation::wants
};

// What is known of an input before it is evaluated.
struct Expectation {
    InputClass input_class = InputClass::ordinary;
    Criterion criterion = Criterion::recorded;
    // Exact results, each with all output words. The first is that of the input itself; the others are those
    // of inputs that the criterion also covers. One whose allowed outputs are among those of an earlier one
    // is left out.
    std::vector<std::vector<double>> wants;
};

// The inputs of one set of images.
struct PreparedScenario {
    std::string name;
    ImageSet images;
    std::vector<std::vector<Word>> image_words;  // in the order of KernelSource::images, header included
    Domain::Inputs inputs;
    std::vector<Expectation> expectations;  // of each input
};

// A check whose shader runs elsewhere, for example in a browser: the text of its kernel, its inputs and what
// they must give. It is judged as by a device that does not preserve NaN, infinity and -0, and without rules:
// no input holds -0.
struct PreparedCheck {
    std::string kernel;         // a fragment shader in GLSL ES 3.00; empty where there is none
    std::string unsupported;    // why there is none
    std::size_t row_words = 0;  // words that it writes for an input: outputs, canary, faults
    std::size_t targets = 0;    // of one draw, four words each
    std::vector<PreparedScenario> scenarios;
};

// Prepares a check of a question with a reference. Throws std::invalid_argument for one without; otherwise as
// Lab::source().
[[nodiscard]] PreparedCheck prepare(const Lab& lab, const Question& question, const RunOptions& options = {});

}  // namespace gloam::check
