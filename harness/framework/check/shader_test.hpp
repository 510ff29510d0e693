// SPDX-License-Identifier: MIT
#pragma once

// Everything needed to test a GLSL function from C++:
//   gloam::check::Lab lab({.include_roots = {"shaders"}});
//   Kernel<float(float)> f(lab, "my.glsl", "my_function");       f(0.5F) runs it on the device
//   compare<float(float)>(lab, "my.glsl", "my_function", reference, {uniform(0, 1)}, {.ulp = 1});
//       judges many inputs by a reference and a budget
//   check_rules<float(float)>(lab, "my.glsl", "my_function", {uniform(1, 2)});
//       judges many inputs by what Vulkan permits: no reference, no tolerance
#include "check/answer.hpp"
#include "check/explain.hpp"
#include "check/kernel.hpp"
#include "check/run.hpp"
