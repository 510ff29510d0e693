// SPDX-License-Identifier: MIT
#include "check/budget.hpp"

#include <fmt/format.h>

namespace gloam::check {

std::string to_text(const Budget& budget) {
    std::string text;
    if (budget.ulp > 0.0)
        text = fmt::format("{:g} ulp{}", budget.ulp,
                           budget.of_largest_component ? " of the largest component" : "");
    if (budget.absolute > 0.0)
        text += fmt::format("{}{:g} absolute", text.empty() ? "" : " or ", budget.absolute);
    if (text.empty()) text = "exact";
    if (budget.backward_ulp > 0) text += fmt::format(" at inputs within {} ulp", budget.backward_ulp);
    return text;
}

}  // namespace gloam::check
