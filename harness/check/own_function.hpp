// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "check/lab.hpp"
#include "check/question.hpp"

namespace gloam::check {

// The range of values for a float or integer parameter, ends included.
struct Range {
    double low = 0.0;
    double high = 0.0;
};
// Ranges by the parameters' names.
using Ranges = std::map<std::string, Range>;

// Parses "x=0:1" as a name and a range. Throws std::invalid_argument for any other text, or low > high.
[[nodiscard]] std::pair<std::string, Range> range_from(const std::string& text);

// The functions that a file itself defines, without those of its includes, if a kernel supports their types.
[[nodiscard]] std::vector<shader::Function> own_functions(const shader::CompileOptions& options,
                                                          const std::string& file);

// The check of any function by the rules alone. Its domain follows from its types where no range is given;
// the images behind its prototypes have random content.
//   float: either sign, 1e-6 to 1e6 by magnitude, zero, infinity, NaN, the largest and the smallest;
//   int: -1000 to 1000; uint: 0 to 2^31; bool: both; a vector, matrix or structure: of these.
// Throws std::invalid_argument for a range without a parameter of this name.
[[nodiscard]] Question question_of(const Lab& lab, const std::string& file, const shader::Function& function,
                                   const Ranges& ranges);

}  // namespace gloam::check
