// SPDX-License-Identifier: MIT
// Methods on their real passes: what they converge to, what those that prepare something make of it, and the
// same on every kind of device. known_pixels.txt has their pictures.
#include <fmt/format.h>

#include "backend/gl/device.hpp"
#include "catalogue/entry.hpp"
#include "effect/planned_run.hpp"
#include "effect/study/closed_form.hpp"
#include "numeric/numbers.hpp"
#include "on_device.hpp"
#include "scene/analytic_scene.hpp"
#include "support/lab.hpp"
#include "support/method_names.hpp"
#include "support/test_name.hpp"
#include "surface_views.hpp"

namespace gloam::effect::method_passes_test {

// Views in closed form: each method converges to its own value.

class ClosedForm : public OnDevice<testing::TestWithParam<std::string>> {
  protected:
    const catalogue::KnownResults& known_ = catalogue::known_results(GetParam());
};

// Within five standard errors of both numbers, of which the known ones have four digits, and what single
// precision takes from the sum of a thousand contributions.
TEST_P(ClosedForm, ConvergesToItsOwnValue) {
    if (!known_.none.empty()) GTEST_SKIP() << known_.none;
    static std::map<std::string, scene::GBuffer> buffers;  // for all methods
    // The taps of other levels lie elsewhere; the entry of sao has them.
    const Settings settings = with({}, "method=" + GetParam() + " mip_distance=0");
    for (const auto& [projection, name] : {std::pair(scene::Projection::perspective, "perspective"),
                                           {scene::Projection::orthographic, "orthographic"}}) {
        for (const scene::ClosedFormView& view : scene::closed_form_views(projection)) {
            const std::string at = std::string(name) + ' ' + view.scene.name;
            const auto [seen, is_new] = buffers.try_emplace(at);
            if (is_new) seen->second = scene::draw(view, 129);
            const double own = view.scene.name.starts_with("plane") ? method_named(GetParam()).on_a_plane
                                                                    : known_.values.at(at);
            const Estimate found = measured(shared_effect(), seen->second, settings, 8);
            EXPECT_NEAR(found.value, own, 5.0 * std::hypot(5e-5, found.error) + 2e-4) << at;
            RecordProperty(at, fmt::format("{:.4f} of {:.4f}", found.value, own));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm, testing::ValuesIn(test::method_names()), test::parameter_name);

class Prepared : public OnDevice<testing::TestWithParam<std::string>> {};

TEST_P(Prepared, NothingIsFoundWhereThereIsNothing) {
    const Settings settings = with({}, "method=" + GetParam() + " radius=0.5");
    for (const backend::Extent extent :
         {backend::Extent{1, 1}, backend::Extent{3, 1}, backend::Extent{17, 9}}) {
        for (const float depth : {infinity, 0.0F, -1.0F, nan}) {
            scene::GBuffer view = view_of(extent, false, [](glm::dvec2) { return 3.0; });
            view.depth.back() = depth;  // a surface before nothing
            EXPECT_THAT(run(view, settings, 2).occlusion, Each(0.0F));
            view.depth.assign(view.depth.size(), depth);
            const Frame frame = run(view, settings, 2);
            EXPECT_THAT(frame.filtered, Each(0.0F));
            EXPECT_THAT(frame.convergence, Each(0.0F));
        }
    }
}

TEST_P(Prepared, RepeatsChangeNothing) {
    const scene::GBuffer view = drawn("corner", {63, 37});
    const Settings settings = with({}, "method=" + GetParam());
    const Frame once = run(view, settings, 3);
    expect_same_images(once, run(view, settings, 3, 3));
    EXPECT_GT(*std::ranges::max_element(once.occlusion), 0.05F);
}

INSTANTIATE_TEST_SUITE_P(All, Prepared, testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return method.prepare != nullptr || method.name == "hemisphere";
                         })),
                         test::parameter_name);

class MssaoLevels : public OnDevice<testing::Test> {};

// The pixels with the middle depths of four stand for these: at even places the farther of the two.
TEST_F(MssaoLevels, HaveTheNearersNormalWhereTwoAreOpposite) {
    const Settings settings = with({}, "method=mssao filter=none history=off");
    constexpr std::array depths{0.02F, 0.01F, 0.0F, 0.03F};
    scene::GBuffer view = step(2.7F, 3.0F);
    const auto corner_of = [&](std::size_t i) { return i % 2 + i / view.extent.width % 2 * 2; };
    for (std::size_t i = 0; i < view.depth.size(); ++i) view.depth[i] += depths.at(corner_of(i));
    const float want = run(view, settings).occlusion.at(beside + 1);
    for (std::size_t i = 0; i < view.normal.size(); ++i)
        if (corner_of(i) == 0) view.normal[i] = -view.normal[i];
    EXPECT_EQ(run(view, settings).occlusion.at(beside + 1), want);
}

// Frames pass by pass on OpenGL 4.5, OpenGL ES 3.1 and the interpreter: the picture is that of Vulkan.

// What a plan shows of a view on a device; nothing where this machine has no such device.
std::vector<float> shown_by(const std::string& device, const Plan& plan, const scene::GBuffer& view,
                            const scene::PassLibrary& passes) {
    PlanMemory memory(plan, view);
    try {
        run(device.empty() ? test::make_lab() : subject::Lab({.device = device}), plan, passes, memory);
    } catch (const backend::gl::Unavailable& error) {
        std::cout << error.what() << '\n';
        return {};
    }
    const subject::Image& result = memory.image(plan.result);
    std::vector<float> shown;
    for (std::size_t i = 0; i < result.words.size(); i += static_cast<std::size_t>(result.element.rows))
        shown.push_back(std::bit_cast<float>(result.words[i]));
    return shown;
}

// Methods that prepare images, and some that do not: tests/catalogue has each as a function. Then passes of
// other frames than the first, and those that few settings have.
std::vector<std::string> frames() {
    std::vector<std::string> all{"method=hemisphere", "method=gtao", "method=bitmask"};
    for (const MethodInfo& method : methods())
        if (method.prepare != nullptr) all.push_back("method=" + method.name);
    all.insert(all.end(),
               {"later without_normals method=gtao remap_b=0.9", "later method=alchemy filter=geometry",
                "later positions method=hemisphere filter=none layers=2"});
    return all;
}

class OpenGlPasses : public OnDevice<testing::TestWithParam<std::string>> {};

TEST_P(OpenGlPasses, GiveThePictureOfVulkan) {
    constexpr backend::Extent extent{49, 35};
    const auto has = [](const char* word) { return GetParam().find(word) != std::string::npos; };
    scene::Scene room = scene::make_scene("room");
    room.camera_path = nullptr;
    room.camera.fovy_rad = 0.9;  // that of the plan
    const scene::GBuffer view = drawn(room, extent);
    const Settings settings = with(Settings{}, "radius=0.5 " + GetParam().substr(GetParam().find("method=")));
    const Plan plan = plan_of(settings,
                              {.view = extent,
                               .moving_objects = has("positions") || has("without_normals"),
                               .first = !has("later"),
                               .normals = !has("without_normals")},
                              passes_);
    const std::vector<float> want =
        has("later") ? shown_by("", plan, view, passes_) : run(view, settings).filtered;
    EXPECT_GT(std::ranges::max(want) - std::ranges::min(want), 0.01F);
    for (const char* device : {"gl:llvmpipe-4.5", "es:llvmpipe-3.1", "interpreter"}) {
        const std::vector<float> got = shown_by(device, plan, view, passes_);
        if (got.empty()) continue;
        EXPECT_LT(largest_difference(got, want), 1e-5) << device;
        RecordProperty(device, numeric::to_short_text(largest_difference(got, want)));
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlPasses, testing::ValuesIn(frames()),
                         [](const auto& info) { return test::test_name(info.param); });

}  // namespace gloam::effect::method_passes_test
