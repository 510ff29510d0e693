// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "subject/own_function.hpp"

namespace gloam::audit {

// The values that a parameter usually has.
struct OrdinaryValues {
    std::string parameter;  // "x"; a structure's member: "light.color"
    std::string text;       // "0 to 1", "unit vectors"
    std::string reason;     // "--range", "comment", "name", "array", "bits", "property", "type"
    subject::Values values;
};

// The values of each in and inout parameter of a function of a file from elsewhere, in order; a structure has
// an entry for each member. The first of these that says something decides:
//   the range with the name of the parameter;
//   its comment, where it names the parameter: docs/verdicts.md has the forms;
//   the name: uv and colours in [0, 1], normals and directions unit vectors, angles in radians, and so on;
//   the array that an integer indexes in its excerpt;
//   shifts, masks and other uses of bits: a uint that the function takes apart is any word;
//   a property, which must hold for any integer that is no count;
//   the type: floats -1000 to 1000, half of them 0 to 1; integers 0 to 7.
// Of a quad, neighbours differ as neighbours() says.
[[nodiscard]] std::vector<OrdinaryValues> ordinary_values(const subject::OwnFunction& own,
                                                          const subject::Ranges& ranges);

// The same values as the domain of the function, in which vectors are also equal, opposite and parallel.
[[nodiscard]] subject::Domain ordinary_domain(const module::Function& function,
                                              const std::vector<OrdinaryValues>& ordinary);

}  // namespace gloam::audit
