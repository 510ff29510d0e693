// SPDX-License-Identifier: MIT
#pragma once

#include "effect/method_functions.hpp"
#include "support/lab.hpp"

namespace gloam::test {

// With a lab that finds them.
class MethodFunctions : public effect::MethodFunctions {
  public:
    using effect::MethodFunctions::MethodFunctions;

    [[nodiscard]] check::Lab lab() const { return make_lab(folder()); }
};

}  // namespace gloam::test
