// SPDX-License-Identifier: MIT
#pragma once

// Whole methods, each as the definition that its source gives: a sum, a horizon, a solid part over the sample
// points of the kernel.
#include "reference/methods_levels.hpp"
