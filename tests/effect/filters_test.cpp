// SPDX-License-Identifier: MIT
// The filters that the setting `filter` chooses from.
#include "effect/errors.hpp"
#include "effect/settings.hpp"
#include "on_device.hpp"
#include "scene/analytic_scene.hpp"

namespace gloam::effect::filters_test {

class FiltersInTheEffect : public OnDevice<testing::TestWithParam<std::string>> {};

// Of few samples: with many there is less to smooth than there is to blur.
TEST_P(FiltersInTheEffect, BringTheCornerNearerToItsClosedForm) {
    const scene::GBuffer view = drawn("corner", {160, 90});
    const Truth truth = truth_of(view, 1.0, scene::corner_occlusion_at);
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings few;
    set(few, "filter", GetParam());
    few.samples = 4;
    effect.begin(view, few);
    const Frame frame = effect.next();
    EXPECT_LT(errors_of(frame.filtered, truth).rmse, 0.8 * errors_of(frame.occlusion, truth).rmse);
}

// The history never sees a filter, whatever the camera does.
TEST_P(FiltersInTheEffect, AreForDisplayOnly) {
    const scene::Scene scene = scene::make_scene("moving");
    std::vector<scene::GBuffer> views;
    for (const int frame : {0, 1, 2})
        views.push_back(drawn("moving", {75, 41}, {.frame = frame, .motion = true}));
    std::vector<Frame> last;
    for (const char* filter : {GetParam().c_str(), "none"}) {
        Settings chosen = with_radius(Settings{}, static_cast<float>(scene.ao_radius));
        set(chosen, "filter", filter);
        last.push_back(run(views, chosen).back());
    }
    expect_same_images(last[0], last[1], {&Frame::occlusion, &Frame::convergence});
    EXPECT_EQ(last[1].filtered, last[1].occlusion);
    EXPECT_NE(last[0].filtered, last[0].occlusion);
}

INSTANTIATE_TEST_SUITE_P(Every, FiltersInTheEffect,
                         testing::Values("convergence", "geometry", "bilateral", "sao"),
                         [](const auto& name) { return name.param; });

}  // namespace gloam::effect::filters_test
