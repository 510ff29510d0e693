// SPDX-License-Identifier: MIT
// The push constants of the raster passes have the layout that C++ gives them.
#include <gtest/gtest.h>

#include <filesystem>

#include "scene/internal/raster_layouts.hpp"
#include "scene/pass_library.hpp"
#include "support/laid_out.hpp"

namespace gloam::scene {
namespace {

void expect_pushed(const char* file, std::size_t bytes, const std::vector<std::string>& members) {
    const PassLibrary passes(GLOAM_GLSL_DIR);
    const shader::ModuleInterface found = shader::reflect(passes.compile(file));
    ASSERT_TRUE(found.push_constants.has_value()) << file;
    EXPECT_EQ(gloam::test::lines_of(found.push_constants->members), members) << file;
    EXPECT_EQ(found.push_constants->size, bytes) << file;
}

TEST(RasterLayouts, PushConstants) {
    using R = RasterConstants;
    expect_pushed("gbuffer.vert", sizeof(R), {MEMBER(R, projection)});
    using P = PeelConstants;
    expect_pushed("peel.frag", sizeof(P), {MEMBER(P, projection), MEMBER(P, reversed_z)});
}

}  // namespace
}  // namespace gloam::scene
