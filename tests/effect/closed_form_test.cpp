// SPDX-License-Identifier: MIT
// What every method makes of views in closed form, by the passes: it converges to the method's own value.
#include <fmt/format.h>

#include "catalogue/entry.hpp"
#include "effect/study/closed_form.hpp"
#include "on_device.hpp"
#include "scene/analytic_scene.hpp"
#include "support/method_names.hpp"

namespace gloam::effect::closed_form_test {

class ClosedForm : public OnDevice<testing::TestWithParam<std::string>> {
  protected:
    const catalogue::KnownResults& known_ = catalogue::known_results(GetParam());
};

// Five standard errors of both numbers, and what single precision takes from the sum of a thousand
// contributions.
double bound_of(double error, double other) {
    return 5.0 * std::hypot(error, other) + 2e-4;
}

constexpr double known_error = 5e-5;  // of four digits

TEST_P(ClosedForm, ConvergesToItsOwnValue) {
    if (!known_.none.empty()) GTEST_SKIP() << known_.none;
    ClosedFormStudy study(device_, passes_, 129);
    Settings settings = with_method(Settings{}, GetParam());
    settings.own.mip_distance = 0.0F;  // whose taps lie elsewhere; the entry of sao has them
    for (const auto& [projection, name] : {std::pair(scene::Projection::perspective, "perspective"),
                                           {scene::Projection::orthographic, "orthographic"}}) {
        for (const scene::ClosedFormView& view : scene::closed_form_views(projection)) {
            const std::string& at = view.scene.name;
            const double own = at.starts_with("plane") ? method_named(GetParam()).on_a_plane
                                                       : known_.values.at(std::string(name) + ' ' + at);
            const Estimate measured = study.measure(view, settings, 8);
            EXPECT_NEAR(measured.value, own, bound_of(known_error, measured.error)) << name << ' ' << at;
            RecordProperty(at, fmt::format("{:.4f} of {:.4f}", measured.value, own));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm, testing::ValuesIn(test::method_names()), test::parameter_name);

// What holds of every method, by the passes themselves.

// The estimate itself.
Settings plain(const std::string& method, float radius) {
    Settings settings = with_radius(with_method(Settings{}, method), radius);
    settings.filter = Filter::none;
    settings.remap_a = 0.0F;
    return settings;
}

class Invariants : public OnDevice<testing::TestWithParam<std::string>> {};

// With normals and without.
TEST_P(Invariants, ABarePlaneIsOpenInImagesOfAnySize) {
    Settings settings = plain(GetParam(), 1.0F);
    settings.least_radius = 0.0F;  // in the smallest a pixel is wider than the radius
    for (const gpu::Extent extent : {gpu::Extent{18, 9}, gpu::Extent{1, 1}}) {
        for (const bool orthographic : {false, true}) {
            scene::GBuffer view = plane(extent, orthographic, {0.4, -0.3, 1.0});
            for (const bool normals : {true, false}) {
                if (!normals) view.normal.clear();
                const Frame frame = run(view, settings);
                for (const float occlusion : frame.occlusion)
                    EXPECT_NEAR(double{occlusion}, method_named(GetParam()).on_a_plane, normals ? 1e-5 : 1e-4)
                        << extent.width << 'x' << extent.height << (normals ? "" : " without normals");
            }
        }
    }
}

// Its normal has a negative z where the camera looks up, and still it faces the eye.
TEST_P(Invariants, AFloorToTheHorizonIsOpen) {
    const gpu::Extent extent{63, 49};
    for (const double pitch : {-0.2, 0.2}) {
        const glm::dvec3 up{0.0, std::cos(pitch), -std::sin(pitch)};
        const scene::GBuffer view = plane(extent, false, up, 1.0, -up);
        const std::vector<float> occlusion = run(view, plain(GetParam(), 0.2F)).occlusion;
        std::size_t seen = 0;
        for (std::size_t i = 0; i < occlusion.size(); ++i) {
            if (!(view.depth[i] < 10.0F)) continue;  // beyond, the radius is less than a pixel
            ++seen;
            EXPECT_NEAR(double{occlusion[i]}, method_named(GetParam()).on_a_plane, 1e-4)
                << "pixel " << i << ", pitch " << pitch << ", depth " << view.depth[i];
        }
        EXPECT_GT(seen, 63U * 5U);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Invariants, testing::ValuesIn(test::method_names()), test::parameter_name);

}  // namespace gloam::effect::closed_form_test
