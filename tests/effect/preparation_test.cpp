// SPDX-License-Identifier: MIT
// The methods that prepare something before their samples, on their real passes: scenes whose result is
// known, and the passes themselves.
#include "effect/preparation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "scene/guard_band.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::vector<std::string> prepared_methods() {
    std::vector<std::string> names;
    for (const MethodInfo& method : methods()) {
        Settings settings;
        settings.method = method.name;
        if (preparation_of(settings, {8, 8})) names.push_back(method.name);
    }
    return names;
}

Settings settings_for(const std::string& method, float radius) {
    return with_radius(with_method(preset_named("paper").settings, method), radius);
}

constexpr double view_height = 2.0;

// A view of a surface whose depth under a ray (orthographic: at a place of the image plane) is given; y up.
scene::GBuffer view_of(gpu::Extent extent, bool orthographic,
                       const std::function<double(glm::dvec2)>& depth) {
    scene::GBuffer view{.extent = extent};
    const double aspect = double{static_cast<double>(extent.width)} / extent.height;
    scene::Camera camera{.view_height = view_height};
    if (orthographic) camera.projection = scene::Projection::orthographic;
    view.camera = scene::make_frame(camera, aspect);
    for (unsigned y = 0; y < extent.height; ++y) {
        for (unsigned x = 0; x < extent.width; ++x) {
            const glm::dvec2 ndc(2.0 * (x + 0.5) / extent.width - 1.0, 2.0 * (y + 0.5) / extent.height - 1.0);
            view.depth.push_back(static_cast<float>(depth(ndc / glm::dvec2(view.camera.p00_p11()))));
        }
    }
    return view;
}

// The plane through (0, 0, -5).
scene::GBuffer plane(gpu::Extent extent, bool orthographic, glm::dvec3 normal) {
    const glm::dvec3 n = glm::normalize(normal);
    scene::GBuffer view = view_of(extent, orthographic, [&](glm::dvec2 at) {
        const double along = n.x * at.x + n.y * at.y;
        return orthographic ? 5.0 + along / n.z : 5.0 * n.z / (n.z - along);
    });
    view.normal.assign(view.depth.size(), glm::vec3(n));
    return view;
}

// A floor from whose middle line the right half rises by 45 degrees.
scene::GBuffer groove(gpu::Extent extent) {
    scene::GBuffer view = view_of(extent, true, [](glm::dvec2 at) { return 5.0 - std::max(at.x, 0.0); });
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    return view;
}

class Prepared : public testing::TestWithParam<std::string> {
  protected:
    Prepared()
        : device_({.device = variable("GLOAM_TEST_DEVICE"),
                   .validation = gpu::Validation::on,
                   .cache_directory = variable("GLOAM_CACHE_DIR")}),
          passes_(GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")) {}

    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), testing::IsEmpty()); }

    [[nodiscard]] Frame run(const scene::GBuffer& view, const Settings& settings, int frames = 1,
                            int repeat = 1) const {
        AmbientOcclusion effect(device_, passes_, view.extent);
        effect.begin(view, settings);
        Frame frame = effect.next(repeat);
        for (int i = 1; i < frames; ++i) frame = effect.next(repeat);
        return frame;
    }

    [[nodiscard]] scene::GBuffer rasterized(const char* name, gpu::Extent extent, double guard = 0.0) const {
        return scene::rasterize(device_, passes_, scene::make_scene(name), extent, {.guard = guard});
    }

    gpu::Device device_;
    scene::PassLibrary passes_;
};

TEST_P(Prepared, ABarePlaneIsOpen) {
    for (const bool orthographic : {false, true}) {
        for (const glm::dvec3 tilt :
             {glm::dvec3(0, 0, 1), glm::dvec3(0.8, -0.5, 1), glm::dvec3(-1.4, 1.0, 1)}) {
            for (const gpu::Extent extent : {gpu::Extent{67, 51}, gpu::Extent{5, 1}, gpu::Extent{1, 3}}) {
                Settings settings = settings_for(GetParam(), 0.5F);
                settings.bias = 2e-5F;
                settings.angle_bias = 0.0F;
                settings.least_radius = 0.0F;
                const Frame frame = run(plane(extent, orthographic, tilt), settings, 2);
                EXPECT_THAT(frame.occlusion, testing::Each(testing::Le(1e-6F)))
                    << extent.width << " x " << extent.height << " tilt " << tilt.x
                    << (orthographic ? " orthographic" : " perspective");
                EXPECT_EQ(frame.work.samples, 32U * extent.width * extent.height);
            }
        }
    }
}

TEST_P(Prepared, NothingIsFoundWhereThereIsNothing) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const gpu::Extent extent : {gpu::Extent{1, 1}, gpu::Extent{3, 1}, gpu::Extent{17, 9}}) {
        for (const float depth : {infinity, 0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
            scene::GBuffer view = view_of(extent, false, [](glm::dvec2) { return 3.0; });
            view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
            const auto expect_open = [&] {
                EXPECT_THAT(run(view, settings_for(GetParam(), 0.5F), 2).occlusion, testing::Each(0.0F));
            };
            view.depth.back() = depth;  // a surface before nothing
            expect_open();
            view.depth.assign(view.depth.size(), depth);
            expect_open();
        }
    }
}

TEST_P(Prepared, RepeatsChangeNothing) {
    const scene::GBuffer view = rasterized("corner", {63, 37});
    const Settings settings = settings_for(GetParam(), 1.0F);
    const Frame once = run(view, settings, 3);
    const Frame thrice = run(view, settings, 3, 3);
    EXPECT_EQ(once.occlusion, thrice.occlusion);
    EXPECT_EQ(once.filtered, thrice.filtered);
    EXPECT_GT(*std::ranges::max_element(once.occlusion), 0.2F);
}

// What is prepared for the band alone is left out; the frame stays as it was.
TEST_P(Prepared, TheBandIsReadWithoutBeingShaded) {
    const scene::GBuffer view = rasterized("corner", {63, 37}, 0.1);
    Settings settings = settings_for(GetParam(), 1.0F);
    settings.guard = 0.1F;
    const Frame shaded = run(view, settings);
    settings.guard_history = false;
    const Frame left_out = run(view, settings);
    EXPECT_EQ(left_out.occlusion, shaded.occlusion);
    EXPECT_LT(left_out.work.samples, shaded.work.samples);
}

TEST_P(Prepared, ATimeForEachPassAndNoneForOtherMethods) {
    const scene::GBuffer view = rasterized("corner", {33, 21});
    const Settings settings = settings_for(GetParam(), 1.0F);
    AmbientOcclusion effect(device_, passes_, view.extent);
    effect.begin(view, settings);
    std::vector<std::string> names;
    for (const PassTime& time : effect.next().times) names.push_back(time.pass);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    std::vector<std::string> expected;
    for (const PreparationPass& pass : preparation_of(settings, view.extent)->passes)
        expected.push_back(pass.name);
    expected.insert(expected.end(), {"ambient_occlusion", "filter_x", "filter_y"});
    EXPECT_EQ(names, expected);

    effect.begin(view, settings_for("hemisphere", 1.0F));
    const Frame other = effect.next();
    EXPECT_EQ(other.times.size(), 3U);
    EXPECT_EQ(other.occlusion, run(view, settings_for("hemisphere", 1.0F)).occlusion);
}

TEST_P(Prepared, HistoryOfHalfPrecision) {
    Settings settings = settings_for(GetParam(), 1.0F);
    settings.precision = HistoryPrecision::float16;
    settings.table_size = 2048;
    const Frame frame = run(rasterized("corner", {33, 21}), settings, 2);
    EXPECT_GT(*std::ranges::max_element(frame.occlusion), 0.2F);
}

INSTANTIATE_TEST_SUITE_P(All, Prepared, testing::ValuesIn(prepared_methods()),
                         [](const auto& info) { return info.param; });

// As Methods.AGrooveHasTheMethodsOwnValue has it for the others.
class Groove : public Prepared {
  protected:
    [[nodiscard]] float at_the_line(Settings settings) const {
        settings.bias = 1e-5F;
        settings.angle_bias = 0.0F;
        settings.samples = 64;
        settings.samples_converged = 64;
        settings.weight_max = 8192.0F;
        const gpu::Extent extent{129, 129};
        const Frame frame = run(groove(extent), settings, 16);
        return frame.occlusion[64 * extent.width + 64];
    }
};

TEST_F(Groove, DualResolutionIsThatOfHbao) {
    Settings settings = settings_for("dual_resolution", 0.5F);
    settings.steps = 16;
    settings.disagreement = 0.0F;
    EXPECT_NEAR(at_the_line(settings), 0.25, 0.03);
}

TEST_F(Groove, SeparableIsCosineWeighted) {
    Settings settings = settings_for("separable", 0.5F);
    settings.epsilon = 1e-3F;  // nothing is carried
    EXPECT_NEAR(at_the_line(settings), 0.146447, 0.03);
}

}  // namespace
}  // namespace gloam::effect
