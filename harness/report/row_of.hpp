// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "check/case.hpp"
#include "report/check_row.hpp"

namespace gloam::report {

// What a check found, as a row: the equation's ID in the catalogue, and the variant it was compiled in.
[[nodiscard]] CheckRow row_of(const std::string& equation, const std::string& variant,
                              const check::Result& result);

// A judged input of a function with that signature.
[[nodiscard]] WorstInput worst_of(const check::Signature& signature, const check::Sample& sample);

}  // namespace gloam::report
