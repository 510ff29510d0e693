// SPDX-License-Identifier: MIT
// Frames pass by pass on OpenGL 4.5, OpenGL ES 3.1 and the interpreter: the picture is that of Vulkan.
#include "backend/gl/device.hpp"
#include "effect/planned_run.hpp"
#include "numeric/numbers.hpp"
#include "on_device.hpp"
#include "support/lab.hpp"
#include "support/method_names.hpp"

namespace gloam::effect::opengl_passes_test {

// What a plan shows of a view.
std::vector<float> shown_by(const check::Lab& lab, const Plan& plan, const scene::GBuffer& view,
                            const scene::PassLibrary& passes) {
    PlanMemory memory(plan, view);
    run(lab, plan, passes, memory);
    const check::Image& result = memory.image(plan.result);
    std::vector<float> shown;
    for (std::size_t i = 0; i < result.words.size(); i += static_cast<std::size_t>(result.element.rows))
        shown.push_back(std::bit_cast<float>(result.words[i]));
    return shown;
}

// By device; none where this machine has no such device.
std::optional<check::Lab> opened(const char* device) {
    try {
        return check::Lab({.device = device});
    } catch (const gl::Unavailable& error) {
        std::cout << error.what() << '\n';
        return std::nullopt;
    }
}

// Those that prepare images, and some that do not: tests/glsl/languages_test.cpp has each as a function.
std::vector<std::string> passes_of_methods() {
    std::vector<std::string> names{"hemisphere", "gtao", "bitmask"};
    const auto prepared =
        test::method_names([](const MethodInfo& method) { return method.prepare != nullptr; });
    names.insert(names.end(), prepared.begin(), prepared.end());
    return names;
}

class OpenGlPasses : public OnDevice<testing::TestWithParam<std::string>> {};

TEST_P(OpenGlPasses, GiveThePictureOfVulkan) {
    const gpu::Extent extent{49, 35};
    scene::Scene room = scene::make_scene("room");
    room.camera_path = nullptr;
    room.camera.fovy_rad = 0.9;  // that of the plan
    const scene::GBuffer view = drawn(room, extent);
    const Settings settings = with_method(preset_named("tssao-paper").settings, GetParam());
    const Plan plan = plan_of(settings, {.view = extent, .first = true}, passes_);
    const std::vector<float> want = run(view, settings).filtered;
    const auto [least, most] = std::ranges::minmax(want);
    EXPECT_GT(most - least, 0.01F);
    for (const char* device : {"gl:llvmpipe-4.5", "es:llvmpipe-3.1", "interpreter"}) {
        const std::optional<check::Lab> lab = opened(device);
        if (!lab) continue;
        const std::vector<float> got = shown_by(*lab, plan, view, passes_);
        ASSERT_EQ(got.size(), want.size());
        const double largest = largest_difference(got, want);
        EXPECT_LT(largest, 1e-5) << device;
        RecordProperty(device, numeric::to_short_text(largest));
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlPasses, testing::ValuesIn(passes_of_methods()), test::parameter_name);

// The passes of other frames than the first, and those that few settings have.
TEST_F(OpenGlPasses, OfLaterFramesAreThoseOfVulkan) {
    const gpu::Extent extent{49, 35};
    const scene::GBuffer& view = drawn("room", extent);
    Settings moving = with_radius(with_method({}, "gtao"), 0.5F);
    moving.remap_b = 0.9F;
    Settings other = with_method(moving, "alchemy");
    other.remap_b = 1.0F;
    other.filter = Filter::geometry;
    Settings layered = with_method(other, "hemisphere");
    layered.filter = Filter::none;
    layered.own.layers = 2;
    const std::pair<Settings, PlanOptions> frames[] = {
        {moving, {.view = extent, .moving_objects = true, .normals = false}},
        {other, {.view = extent}},
        {layered, {.view = extent, .moving_objects = true}}};
    for (const auto& [settings, options] : frames) {
        const Plan plan = plan_of(settings, options, passes_);
        const std::vector<float> want = shown_by(test::make_lab(), plan, view, passes_);
        EXPECT_GT(std::ranges::max(want) - std::ranges::min(want), 0.01F);
        for (const char* device : {"gl:llvmpipe-4.5", "es:llvmpipe-3.1", "interpreter"}) {
            if (const std::optional<check::Lab> lab = opened(device)) {
                const std::vector<float> got = shown_by(*lab, plan, view, passes_);
                EXPECT_LT(largest_difference(got, want), 1e-5) << device;
            }
        }
    }
}

}  // namespace gloam::effect::opengl_passes_test
