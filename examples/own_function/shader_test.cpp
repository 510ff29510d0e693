// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <gloam/shader_test.hpp>

#include <cmath>

using namespace gloam::shader_test;

// Tests share a Lab, so that the device is opened once.
const Lab& shared_lab() {
    static const Lab lab({.validation = true, .include_roots = {SHADER_DIR}});
    return lab;
}

TEST(Tone, MatchesReinhard) {
    const Function<float(float)> tone(shared_lab(), "tone.glsl", "tone_reinhard");
    const auto reinhard = [](double x) { return x / (1.0 + x); };
    const Answer answer = tone.compare(reinhard, {log_uniform(1e-6, 1e6)}, {.ulp = 4});
    EXPECT_TRUE(answer.passed()) << answer;
}

TEST(Fog, CallsTheShaderLibraryOfThePackage) {
    const Lab lab({.validation = true, .include_roots = {SHADER_DIR, GLOAM_GLSL_DIR}});
    const Function<float(float)> fog_weight(lab, "fog.glsl", "fog_weight");
    EXPECT_EQ(fog_weight(1.0F), 0.5F);
    EXPECT_EQ(fog_weight(INFINITY), 1.0F);
}
