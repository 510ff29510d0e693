// SPDX-License-Identifier: MIT
// What holds of every method, by the passes themselves.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// The estimate itself.
Settings plain(const std::string& method, float radius) {
    Settings settings = with_radius(with_method(Settings{}, method), radius);
    settings.filter = Filter::none;
    settings.remap_a = 0.0F;
    return settings;
}

class Invariants : public testing::TestWithParam<std::string> {
  protected:
    Invariants()
        : device_({.device = variable("GLOAM_TEST_DEVICE"),
                   .validation = gpu::Validation::on,
                   .cache_directory = variable("GLOAM_CACHE_DIR")}),
          passes_(GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")) {}

    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), testing::IsEmpty()); }

    gpu::Device device_;
    scene::PassLibrary passes_;
};

std::vector<float> shade(AmbientOcclusion& effect, const scene::GBuffer& view, const Settings& settings) {
    effect.begin(view, settings);
    return effect.next().occlusion;
}

// The planes and the direction of depth are the depth buffer's business, not the estimator's.
TEST_P(Invariants, HowDepthIsStoredMakesNoDifference) {
    scene::Scene corner = scene::make_scene("corner");
    const gpu::Extent extent{48, 27};
    const scene::GBuffer reversed = scene::rasterize(device_, passes_, corner, extent);
    const Settings settings = plain(GetParam(), static_cast<float>(corner.ao_radius));
    AmbientOcclusion effect(device_, passes_, extent);
    const std::vector<float> known = shade(effect, reversed, settings);
    ASSERT_TRUE(corner.camera.reversed_z);
    for (const bool reversed_z : {true, false}) {
        for (const double far : {30.0, std::numeric_limits<double>::infinity()}) {
            corner.camera.reversed_z = reversed_z;
            corner.camera.far = far;
            scene::GBuffer view = reversed;
            view.camera = scene::make_frame(corner.camera, 48.0 / 27.0);
            EXPECT_EQ(shade(effect, view, settings), known) << reversed_z << ' ' << far;
            // Drawn through that depth buffer, depths differ by its rounding, and samples at a border of a
            // pixel or of a surface fall to the other side.
            const auto drawn = shade(effect, scene::rasterize(device_, passes_, corner, extent), settings);
            EXPECT_LT(errors_of(drawn, known).rmse, 0.01) << reversed_z << ' ' << far;
        }
    }
}

// A tilted plane over all of the image.
scene::GBuffer plane(gpu::Extent extent, scene::Projection projection) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.3, 1.0));
    scene::AnalyticScene scene;
    scene.add_plane({{0, 0, -5}, normal});
    scene::GBuffer view{.extent = extent};
    view.camera = scene::make_frame({.projection = projection},
                                    static_cast<double>(extent.width) / static_cast<double>(extent.height));
    const glm::dvec2 scale(view.camera.p00_p11());
    for (std::uint32_t y = 0; y < extent.height; ++y) {
        for (std::uint32_t x = 0; x < extent.width; ++x) {
            const glm::dvec2 size(extent.width, extent.height);
            const glm::dvec2 place = ((2.0 * glm::dvec2(x, y) + 1.0) / size - 1.0) / scale;
            const auto hit = projection == scene::Projection::orthographic
                                 ? scene.first_hit({place, 0.0}, {0, 0, -1})
                                 : scene.first_hit({0, 0, 0}, {place, -1.0});
            view.depth.push_back(static_cast<float>(hit.value().distance));
            view.normal.emplace_back(normal);
        }
    }
    return view;
}

TEST_P(Invariants, ABarePlaneIsOpenInImagesOfAnySize) {
    const double open = with_method(Settings{}, GetParam()).remap_a > 0.0F ? 0.5 : 0.0;
    Settings settings = plain(GetParam(), 1.0F);
    settings.least_radius = 0.0F;  // in the smallest a pixel is wider than the radius
    for (const gpu::Extent extent : {gpu::Extent{1, 1}, gpu::Extent{3, 1}, gpu::Extent{17, 9}}) {
        AmbientOcclusion effect(device_, passes_, extent);
        for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
            for (const float occlusion : shade(effect, plane(extent, projection), settings))
                EXPECT_NEAR(double{occlusion}, open, 1e-5) << extent.width << 'x' << extent.height;
        }
    }
}

// No invocation asks another of its subgroup for anything: results cannot depend on the subgroup's
// size.
TEST(Shaders, NothingDependsOnSubgroups) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLOAM_GLSL_DIR)) {
        if (!entry.is_regular_file()) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        for (const char* word : {"subgroup", "gl_Subgroup"})
            EXPECT_THAT(text.str(), testing::Not(testing::HasSubstr(word))) << entry.path();
        ++files;
    }
    EXPECT_GT(files, 50U);
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const MethodInfo& method : methods()) names.push_back(method.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, Invariants, testing::ValuesIn(method_names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace gloam::effect
