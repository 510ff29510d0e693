// SPDX-License-Identifier: MIT
#pragma once

// Everything needed to test a GLSL function from C++:
//   using namespace gloam::shader_test;
//   const Lab lab({.include_roots = {"shaders"}});
//   const Function<float(float)> f(lab, "my.glsl", "my_function");
//   f(0.5F)                                          runs it on the device
//   f.compare(reference, {uniform(0, 1)}, {.ulp = 1})    judges many inputs by a reference and a budget
//   f.check_rules({uniform(1, 2)})                   judges them by what Vulkan permits: no reference
//   f.property({uniform(0, 1)}, [](float x, float y) { return y <= x; })    tests what must hold
//   audit(f, {uniform(0, 1)})                        says where the function itself goes wrong
//   f.explain(0.5F)                                  shows one input, operation by operation
// And a whole shader with its own main(): pass/pass.hpp
//   const Pass blur(lab, "blur.comp");
//   const PassResult out = blur.run({{"source", picture}, {"radius", 2}});
//   out.image("result").compare(reference, 1e-6)
#include "gloam/audit/audit.hpp"     // IWYU pragma: export
#include "gloam/judge/function.hpp"  // IWYU pragma: export
#include "gloam/pass/pass.hpp"       // IWYU pragma: export

// The words of a test, whichever room has them.
namespace gloam::shader_test {
using namespace audit;
using namespace judge;
using namespace pass;
using namespace subject;
}  // namespace gloam::shader_test
