// SPDX-License-Identifier: MIT
// Every method as a fragment shader of OpenGL ES 3.0: the results are those of Vulkan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "gathers.hpp"

namespace gloam {
namespace opengl_methods_test {

using test::Camera;
using test::Gather;
using test::Method;
using test::Samples;
using Inputs = std::vector<check::Kernel<Gather>::Inputs>;

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const effect::MethodInfo& method : effect::methods()) names.push_back(method.name);
    return names;
}

class OpenGlMethods : public testing::TestWithParam<std::string> {
  protected:
    // Waves on a tilted plane, in front of a wall.
    static float depth(glm::ivec2 p) {
        const auto x = static_cast<float>(p.x);
        const auto y = static_cast<float>(p.y);
        return p.x > 40 ? 6.5F : 5.0F + 0.01F * x + 0.2F * std::sin(0.3F * x) * std::cos(0.23F * y);
    }
    static glm::vec3 normal(glm::ivec2 p) {
        return glm::normalize(glm::vec3(0.2F * std::cos(0.3F * static_cast<float>(p.x)), 0.1F, 1.0F));
    }
    // Whatever a method makes of it: tests/effect/opengl_passes_test.cpp prepares it.
    static glm::vec4 prepared(glm::ivec2 p) { return {depth(p), 0.1F * depth(p), -depth(p), 1.0F}; }

    static Inputs inputs(const Camera& camera) {
        Inputs all;
        for (int y = 4; y < camera.size.y; y += 6) {
            for (int x = 4; x < camera.size.x; x += 6) {
                const glm::vec2 ndc =
                    (2.0F * glm::vec2(x, y) + 1.0F - glm::vec2(camera.size)) / glm::vec2(camera.size);
                const float d = depth({x, y});
                const auto first = static_cast<unsigned>(16 * (x + y));
                const Samples samples{
                    .radius = 0.6F, .bias = 1e-3F, .angle = 0.7F, .first = first, .count = 16};
                all.emplace_back(glm::vec3(ndc / camera.p00_p11 * d, -d), normal({x, y}), camera, samples,
                                 Method{.steps = 4});
            }
        }
        return all;
    }

    test::MethodFunctions functions;
};

TEST_P(OpenGlMethods, GiveTheResultsOfVulkan) {
    const std::string& method = GetParam();
    std::optional<check::Lab> opengl;
    try {
        opengl.emplace(check::LabOptions{.device = "es:llvmpipe-3.0",
                                         .include_roots = {functions.folder(), GLOAM_GLSL_DIR},
                                         .cache_directory = test::cache_directory()});
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    const check::Lab vulkan = functions.lab();
    const Camera camera{glm::vec2(1.8F, -2.0F), glm::ivec2(64, 48), false};
    const Inputs points = inputs(camera);
    const std::string file = test::MethodFunctions::file(method);
    const auto clamped = check::Border::clamp;
    const check::ImageSet images = test::declared_in(
        test::packed_method(functions, file),
        {{"gloam_fetch_depth", check::make_image<float>(camera.size, depth, clamped)},
         {"gloam_fetch_normal", check::make_image<glm::vec3>(camera.size, normal, clamped)},
         {"gloam_fetch_prepared", check::make_image<glm::vec4>(camera.size, prepared, clamped)}});
    const auto got = check::Kernel<Gather>(*opengl, file, effect::method_function)(points, images);
    const auto want = check::Kernel<Gather>(vulkan, file, effect::method_function)(points, images);
    float largest = 0.0F;
    float spread = 0.0F;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(got[i].y, want[i].y) << "samples of point " << i;
        if (want[i].y == 0.0F) continue;
        largest = std::max(largest, std::abs(got[i].x / got[i].y - want[i].x / want[i].y));
        spread = std::max(spread, std::abs(want[i].x / want[i].y - want[0].x / want[0].y));
    }
    EXPECT_LT(largest, 1e-6F);
    EXPECT_GT(spread, 1e-3F);
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlMethods, testing::ValuesIn(method_names()),
                         [](const auto& info) { return info.param; });

}  // namespace opengl_methods_test
}  // namespace gloam
