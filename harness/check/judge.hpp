// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "check/budget.hpp"
#include "check/census.hpp"
#include "check/domain.hpp"
#include "check/image.hpp"
#include "check/signature.hpp"

namespace gloam::check {

// A reference without its C++ types: input words in, one double for each output word.
using Reference =
    std::function<void(const ImageSet& images, std::span<const Word> inputs, std::vector<double>& outputs)>;

// The values that every float output must lie in, for every input whatever. NaN is never inside.
struct Codomain {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

// The rules by which outputs are judged.
struct Rules {
    Signature signature;
    Reference reference;
    Budget budget;
    Codomain codomain;
    // Inputs for which the budget is promised; empty: all. Elsewhere (overflow in between, say) only the
    // codomain is.
    std::function<bool(std::span<const Word>)> promised;
    // Whether the device keeps NaN, infinity and signed zero. If not, inputs and references that hold one are
    // only recorded.
    bool judge_nan = true;
};

// Judges every output of a run. `outputs`: count x output words, in the order of the inputs.
[[nodiscard]] Census judge(const Rules& rules, const Domain::Inputs& inputs, std::span<const Word> outputs,
                           const ImageSet& images = {}, const std::string& scenario = {});

}  // namespace gloam::check
