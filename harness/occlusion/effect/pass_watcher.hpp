// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace gloam::effect {

struct Step;

// Called before a pass runs, by itself, and after: tests of single passes read what its bindings hold
// (internal/steps.hpp).
using PassWatcher = std::function<void(const Step& pass, bool after)>;

}  // namespace gloam::effect
