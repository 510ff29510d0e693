// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "check/lab.hpp"
#include "check/question.hpp"

namespace gloam::check {

// The values that a float or integer parameter is drawn from, ends included.
struct Range {
    double low = 0.0;
    double high = 0.0;
};
// By the parameter's name.
using Ranges = std::map<std::string, Range>;

// "x=0:1" as a name and a range. Throws std::invalid_argument for anything else, or low > high.
[[nodiscard]] std::pair<std::string, Range> range_from(const std::string& text);

// The functions that a file itself defines whose types a kernel can have, without those of its includes.
[[nodiscard]] std::vector<shader::Function> own_functions(const shader::CompileOptions& options,
                                                          const std::string& file);

// The check of anybody's function by the rules alone: a domain by its types where no range is given, images
// of random content behind the prototypes that it reads.
//   float: either sign, 1e-6 to 1e6 by magnitude, zero, infinity, NaN, the largest and the smallest;
//   int: -1000 to 1000; uint: 0 to 2^31; bool: both; a vector, matrix or structure: of these.
// Throws std::invalid_argument for a range whose name no parameter has.
[[nodiscard]] Question question_of(const Lab& lab, const std::string& file, const shader::Function& function,
                                   const Ranges& ranges);

}  // namespace gloam::check
