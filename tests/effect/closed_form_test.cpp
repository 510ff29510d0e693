// SPDX-License-Identifier: MIT
// What every method makes of views in closed form, by the passes: it converges to the method's own value.
#include "effect/study/closed_form_study.hpp"
#include "on_device.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "effect/methods.hpp"
#include "effect/study/own_value.hpp"
#include "support/method_names.hpp"

namespace gloam::effect {
namespace closed_form_test {

class ClosedForm : public OnDevice<testing::TestWithParam<std::string>> {};

// Five standard errors of both numbers, each from the spread of its parts, and what single precision takes
// from the sum of a thousand contributions. The own value is that on an image of so many pixels, so that no
// error of resolution is in it.
double bound_of(const Estimate& own, const Estimate& measured) {
    return 5.0 * std::hypot(own.error, measured.error) + 2e-4;
}

TEST_P(ClosedForm, ConvergesToItsOwnValue) {
    if (own_value_of(GetParam()).integrand == nullptr) GTEST_SKIP() << own_value_of(GetParam()).none;
    const ClosedFormOptions options{.frames = 8};
    ClosedFormStudy study(device_, passes_, options.pixels);
    Settings settings = with_method(Settings{}, GetParam());
    settings.own.mip_distance = 0.0F;  // whose taps lie elsewhere; see method_gathers_test
    for (const scene::Projection projection :
         {scene::Projection::perspective, scene::Projection::orthographic}) {
        for (const scene::ClosedFormView& view : scene::closed_form_views(projection)) {
            const Estimate own = *own_value(view, settings, options.pixels, 1e-3);
            const Estimate measured = study.measure(view, settings, options);
            EXPECT_NEAR(measured.value, own.value, bound_of(own, measured)) << view.name;
            RecordProperty(view.name, fmt::format("{:.4f} of {:.4f}", measured.value, own.value));
        }
    }
}

// On a plane the normal from depth differs from the plane's by rounding only; this changes less than the
// spread of the samples. A result that uses other pixels' results is affected by the edges in them.
TEST_P(ClosedForm, NormalsFromTheDepthMakeNoDifference) {
    const ClosedFormOptions given{.frames = 4};
    ClosedFormOptions reconstructed = given;
    reconstructed.reconstruct_normals = true;
    ClosedFormStudy study(device_, passes_, given.pixels);
    const Settings settings = with_method(Settings{}, GetParam());
    for (const scene::ClosedFormView& view : scene::closed_form_views(scene::Projection::perspective)) {
        const bool made_of_others = own_value_of(GetParam()).integrand == nullptr;
        if (!view.flat || (made_of_others && !view.name.starts_with("plane"))) continue;
        const Estimate known = study.measure(view, settings, given);
        const Estimate found = study.measure(view, settings, reconstructed);
        EXPECT_NEAR(found.value, known.value, bound_of(known, found)) << view.name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm, testing::ValuesIn(test::method_names()), test::parameter_name);

}  // namespace closed_form_test
}  // namespace gloam::effect
