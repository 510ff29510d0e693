// SPDX-License-Identifier: MIT
#pragma once

// Matchers for GoogleMock. The other headers need no test library.
#include <gmock/gmock.h>

#include <vector>

#include "numeric/numbers.hpp"
#include "subject/signature.hpp"

namespace gloam::judge {

// EXPECT_THAT(answer, Passes()): of an Answer, a PropertyResult or an ImageComparison, whose text a failure
// shows.
MATCHER(Passes, negation ? "fails" : "passes") {
    if constexpr (requires { arg.passed(); }) {
        return arg.passed();
    } else {
        return static_cast<bool>(arg);
    }
}

// EXPECT_THAT(tone(0.3F), WithinUlp(3.0 / 13.0, 2)): each float within so many units in the last place of the
// one wanted, which may be in double; integers and bools are equal. Vectors, matrices, arrays and structures
// by their scalars. A failure names the worst component.
MATCHER_P2(WithinUlp, want, ulp, testing::PrintToString(ulp) + " ulp from " + testing::PrintToString(want)) {
    std::vector<double> got;
    std::vector<double> wanted;
    subject::append_numbers(arg, got);
    subject::append_numbers(want, wanted);
    if (got.size() != wanted.size()) {
        *result_listener << got.size() << " numbers, expected " << wanted.size();
        return false;
    }
    double worst = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
        const double error = numeric::ulp_error(static_cast<float>(got[i]), wanted[i]);
        if (error <= worst) continue;
        worst = error;
        at = i;
    }
    *result_listener << worst << " ulp off in component " << at;
    return worst <= static_cast<double>(ulp);
}

}  // namespace gloam::judge
