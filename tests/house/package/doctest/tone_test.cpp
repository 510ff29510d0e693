// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <gloam/shader_test.hpp>

using namespace gloam::shader_test;

TEST_CASE("tone_reinhard") {
    const Lab lab({.validation = true, .include_roots = {SHADER_DIR}});
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    CHECK(tone(1.0F) == 0.5F);
    const Answer answer =
        tone.compare([](double x) { return x / (1.0 + x); }, {log_uniform(1e-6, 1e6)}, {.ulp = 4});
    INFO(answer);
    CHECK(answer.passed());
}
