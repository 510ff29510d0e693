// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "subject/domain.hpp"
#include "subject/lab.hpp"

namespace gloam::subject {

// A function of a file from elsewhere that can be checked; `file` is OwnFile::name.
struct OwnFunction : KernelSource {
    std::string name;     // "f", or "f(vec2, float)" if the file defines others of this name
    std::string comment;  // of source::Excerpt::comments

    // Whether it is a property (Question::must_hold): it gives bools alone, and its name begins with test_ or
    // a line of its comment is "must hold".
    [[nodiscard]] bool is_property() const;
};

// One that cannot.
struct Skipped {
    std::string name;  // "f(vec2, sampler2D)"
    std::string why;
    bool is_error = false;  // its text is no valid GLSL
};

struct OwnFunctions {
    std::vector<OwnFunction> found;
    std::vector<Skipped> left_out;
};

// The functions that the file of a lab's options itself defines, without main and those of its includes, in
// their order. `names`: only these, each "f" for all functions of this name, or "f(vec2, float)"; empty: all.
// Throws std::invalid_argument for a name that the file does not define.
[[nodiscard]] OwnFunctions own_functions(const LabOptions& options,
                                         const std::vector<std::string>& names = {});

// The names of a parameter's values, for ranges: "x", or those of the members, "sphere.radius".
[[nodiscard]] std::vector<std::string> value_names(const module::Type& type, const std::string& name);

// The inputs of a function that is checked by the rules alone. They follow from its types where no range is
// given:
//   float: half of them 0 to 1, the others of either sign and 1e-6 to 1e6 by magnitude, with zero, infinity,
//   NaN, the largest and the smallest;
//   float16_t: as float, in its format;
//   int: half of them 0 to 7, the others -1000 to 1000; uint: half of them 0 to 7, the others up to 2^31;
//   bool: both; a vector, matrix or structure: of these.
// Of a quad, most neighbours differ a little (neighbours()).
[[nodiscard]] Domain domain_of(const OwnFunction& own, const Ranges& ranges);

}  // namespace gloam::subject
