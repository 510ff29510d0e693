// SPDX-License-Identifier: MIT
// The views whose occlusion is known, and the integrals that methods' results are compared with, against
// closed forms.
#include "effect/study/own_value.hpp"

#include "effect/methods.hpp"
#include "scene/gbuffer.hpp"
#include "support/test.hpp"

namespace gloam::effect::own_value_test {

using scene::ClosedFormView;
using scene::Projection;

constexpr double tolerance = 2e-4;
constexpr double pi = std::numbers::pi;

ClosedFormView view_named(const std::string& name, Projection projection) {
    for (const ClosedFormView& view : scene::closed_form_views(projection))
        if (view.name == name) return view;
    throw std::invalid_argument(name);
}

// Occlusion by rays through the scene itself: cosine-weighted, linear falloff.
Estimate traced(const ClosedFormView& view) {
    const glm::dvec3 helper = std::abs(view.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, view.normal));
    const glm::dvec3 bitangent = glm::cross(view.normal, tangent);
    return expectation(
        [&](const std::array<double, 3>& u) {
            const glm::dvec2 aside =
                std::sqrt(u[0]) * glm::dvec2(std::cos(2 * pi * u[1]), std::sin(2 * pi * u[1]));
            const glm::dvec3 direction =
                aside.x * tangent + aside.y * bitangent + std::sqrt(1.0 - u[0]) * view.normal;
            const auto hit = view.scene.first_hit(view.point + 1e-7 * view.normal, direction);
            return glm::dvec2(hit ? std::max(1.0 - hit->distance, 0.0) : 0.0, 1.0);
        },
        tolerance);
}

TEST(ClosedFormViews, TheirScenesHaveTheOcclusionThatTheySay) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const ClosedFormView& view : scene::closed_form_views(projection)) {
            const Estimate found = traced(view);
            EXPECT_NEAR(found.value, view.occlusion, 4.0 * found.error + 1e-5) << view.name;
        }
    }
}

// A point of the half ball over the view's point, uniform in direction and distance.
glm::dvec3 around(const ClosedFormView& view, const std::array<double, 3>& u) {
    const double height = 2.0 * u[0] - 1.0;
    const double angle = 2.0 * pi * u[1];
    const double across = std::sqrt(1.0 - height * height);
    const glm::dvec3 offset = u[2] * glm::dvec3(across * std::cos(angle), across * std::sin(angle), height);
    return glm::dot(offset, view.normal) > 0.0 ? offset : -offset;
}

// What of the open space that the point sees within the radius is hidden from the eye.
double hidden_share(const ClosedFormView& view) {
    const bool orthographic = view.camera.projection == Projection::orthographic;
    const auto blocked = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const auto hit = view.scene.first_hit(from, to - from);
        return hit && hit->distance < 1.0;
    };
    const auto hidden = [&](const std::array<double, 3>& u) {
        const glm::dvec3 start = view.point + 1e-6 * view.normal;
        const glm::dvec3 at = start + around(view, u);
        if (blocked(start, at)) return glm::dvec2(0.0);
        const glm::dvec3 eye = orthographic ? glm::dvec3(glm::dvec2(at), 0.0) : glm::dvec3(0.0);
        return glm::dvec2(blocked(at, eye) ? 1.0 : 0.0, 1.0);
    };
    return expectation(hidden, 0.01).value;
}

TEST(ClosedFormViews, ShowAllOfTheirSceneOrSayThatTheyDoNot) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const ClosedFormView& view : scene::closed_form_views(projection))
            EXPECT_EQ(hidden_share(view) == 0.0, view.seen_whole) << view.name << ' ' << hidden_share(view);
    }
}

TEST(ClosedFormViews, ShowTheirPointInTheMiddle) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const ClosedFormView& view : scene::closed_form_views(projection)) {
            const scene::GBuffer buffer = scene::draw(view, 65);
            const std::size_t middle = std::size_t{65} * 32 + 32;
            EXPECT_NEAR(double{buffer.depth[middle]}, -view.point.z, 1e-6) << view.name;
            EXPECT_EQ(buffer.normal[middle], glm::vec3(view.normal)) << view.name;
            EXPECT_EQ(buffer.border, (gpu::Extent{32, 32})) << view.name;
            for (std::size_t i = 0; i < buffer.depth.size(); ++i) {
                const double length = glm::length(glm::dvec3(buffer.normal[i]));
                EXPECT_NEAR(length, std::isfinite(buffer.depth[i]) ? 1.0 : 0.0, 1e-6) << view.name;
            }
        }
    }
}

TEST(ClosedFormViews, AreDrawnInOddSizesOnly) {
    const ClosedFormView view = view_named("pit", Projection::perspective);
    for (const std::uint32_t size : {0U, 1U, 2U, 64U}) {
        EXPECT_THROW((void)scene::draw(view, size), std::invalid_argument) << size;
    }
}

TEST(Expectation, OfWhatIsKnown) {
    const Estimate volume = expectation(
        [](const std::array<double, 3>& u) {
            return glm::dvec2(u[0] * u[0] + u[1] * u[1] + u[2] * u[2] < 1.0 ? 1.0 : 0.0, 1.0);
        },
        tolerance);
    EXPECT_NEAR(volume.value, pi / 6.0, 4.0 * volume.error);
    EXPECT_LE(volume.error, tolerance);
    const auto weighted = [](const std::array<double, 3>& u) { return u[1] * glm::dvec2(u[0] * u[1], 1.0); };
    EXPECT_NEAR(expectation(weighted, 1e-5).value, 1.0 / 3.0, 1e-4);
    EXPECT_EQ(expectation([](const auto&) { return glm::dvec2(0.0); }, tolerance).value, 0.0);
    EXPECT_EQ(expectation([](const auto&) { return glm::dvec2(3.0, 1.0); }, tolerance).value, 1.0);
}

TEST(OwnValues, EveryMethodHasOneOrSaysWhyNot) {
    for (const MethodInfo& method : methods()) {
        const OwnValue& own = own_value_of(method.name);
        EXPECT_NE(own.integrand == nullptr, own.none.empty()) << method.name;
    }
    EXPECT_EQ(own_values().size(), methods().size());
}

// Nothing but the estimator itself: no bias, so many steps that horizons are found where they are, nothing
// taken for another object, walls as thick as they look.
Settings ideal(const std::string& method) {
    Settings settings = with_method(Settings{}, method);
    settings.bias = 1e-9F;  // what rounding in double may do to a plane
    settings.own.angle_bias = 0.0F;
    settings.own.epsilon = method == "sao" ? settings.own.epsilon : 0.0F;
    settings.own.intensity = method == "hbao" || method == "hbao_study" || method == "hsao" ? 1.0F : 0.2F;
    settings.own.range = 1e6F;
    settings.own.thickness = 1e6F;
    settings.own.steps = method == "ssdo" ? 1 : 64;
    return settings;
}

constexpr auto both = {Projection::perspective, Projection::orthographic};
constexpr auto parallel = {Projection::orthographic};

void expect_own_value(const std::string& method, const std::string& view, double expected, double allowed,
                      std::initializer_list<Projection> projections = both) {
    for (const Projection projection : projections) {
        const auto found = own_value(view_named(view, projection), ideal(method), 0, tolerance);
        ASSERT_TRUE(found.has_value()) << method;
        EXPECT_NEAR(found->value, expected, 4.0 * found->error + allowed)
            << method << ", " << view << (projection == Projection::perspective ? "" : ", orthographic");
    }
}

constexpr double exact = 1e-5;

TEST(OwnValues, OfABarePlane) {
    for (const OwnValue& own : own_values()) {
        if (own.integrand == nullptr || own.of_pixels) continue;
        for (const char* plane : {"plane 0", "plane 30", "plane 60"})
            expect_own_value(own.name, plane, method_named(own.name).on_a_plane, exact);
    }
}

// Where nothing depends on the distance (T11, T12): closed forms of each measure. Slices meet the nearest of
// their samples at a distance that their jitter decides: what the falloff takes there is allowed.
TEST(OwnValues, OfGroovesAndPits) {
    const double cosine = 0.5 * (1.0 - std::cos(0.25 * pi));
    const double root = std::sqrt(0.5);
    struct Case {
        const char* method;
        const char* view;
        double expected;
        double allowed = exact;
        std::initializer_list<Projection> projections = both;
    };
    for (const Case& known : {
             Case{"hemisphere", "groove", cosine},
             {"hemisphere", "valley", 2.0 * cosine},
             {"hemisphere", "pit", 0.5},
             {"filion", "groove", 0.25},
             {"filion", "valley", 0.5},
             {"filion", "pit", root},
             {"crytek", "groove", 0.625},
             {"poisson", "groove", cosine},
             {"poisson", "pit", 0.5},
             {"ssdo", "groove", cosine},
             {"ssdo", "pit", 0.5},
             // Under the disc of a perspective view lies another part of a slope than under the ball. A
             // rising line that leaves the ball by its near side is not believed: integrated over the taps
             // that are.
             {"volumetric", "groove", 0.5 + 1.0 / (4.0 * pi), exact, parallel},
             {"volumetric", "valley", 0.5 + 1.0 / (2.0 * pi), exact, parallel},
             // Of two balls the excess of both; a line of a smaller ball is that of the larger one.
             {"volumetric_two", "groove", 0.5 + 1.0 / (2.0 * pi), exact, parallel},
             // The cosine of 45 degrees, for the 45 degrees' cosine of the radii.
             {"issao_basic", "pit", 0.5, exact, parallel},
             {"angle", "groove", 1.0 - 0.828708, exact, parallel},
             {"angle", "pit", 0.5, exact, parallel},
             {"gtao", "groove", cosine, 0.003},
             {"gtao", "pit", 0.5, 0.003},
             {"bitmask", "groove", cosine, 0.01},
             {"bitmask", "pit", 0.5, 0.01},
             {"hbao", "groove", 0.25, 0.003},
             {"hbao", "valley", 0.5, 0.003},
             {"hbao", "pit", root, 0.003},
             {"hbao_study", "groove", 0.25, 0.003},
             {"hbao_study", "valley", 0.5, 0.003},
             {"hbao_study", "pit", root, 0.003},
             {"hsao", "groove", 0.25, 0.003},
             {"hsao", "pit", root, 0.003},
         })
        expect_own_value(known.method, known.view, known.expected, known.allowed, known.projections);
}

// A sphere of radius 1 has q = k R / 2 = 1/2 everywhere, and the mean of sin^2 is q^2 / (1 + q^2).
TEST(OwnValues, OfCurvature) {
    expect_own_value("curvature", "sphere", 0.2, exact);
}

TEST(OwnValues, OfPixelsAreNoneWithoutThem) {
    const ClosedFormView view = view_named("pit", Projection::perspective);
    for (const OwnValue& own : own_values()) {
        const bool known = own_value(view, with_method(Settings{}, own.name), 0, 0.01).has_value();
        EXPECT_EQ(known, own.integrand != nullptr && !own.of_pixels) << own.name;
    }
}

// With the distance: what is cosine-weighted and falls linearly is the truth itself.
TEST(OwnValues, OfPointsAreTheTruthItself) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const ClosedFormView& view : scene::closed_form_views(projection)) {
            if (!view.seen_whole) continue;
            const auto found = own_value(view, ideal("hemisphere"), 0, tolerance);
            EXPECT_NEAR(found->value, view.occlusion, 4.0 * found->error + exact) << view.name;
        }
    }
}

// A sweep too, in the limit of many steps but for what the ends of its marches leave out, and nearly so with
// six. The wall of the step is seen edge-on. Along the view between floor and ceiling six steps pass the
// ceiling over the point.
TEST(OwnValues, OfASweepAreTheTruthInTheLimitAndNearlySoBefore) {
    for (const Projection projection : both) {
        for (const ClosedFormView& view : scene::closed_form_views(projection)) {
            if (!view.seen_whole || view.name == "step") continue;
            Settings settings = ideal("sweep");
            const auto limit = own_value(view, settings, 0, tolerance);
            EXPECT_NEAR(limit->value, view.occlusion, 4.0 * limit->error + 0.004) << view.name;
            if (view.name == "ceiling") continue;
            settings.own.steps = 6;
            const auto six = own_value(view, settings, 0, tolerance);
            EXPECT_NEAR(six->value, view.occlusion, 4.0 * six->error + 0.014) << view.name;
        }
    }
}

// CS-M: 4 sigma / (pi r) cos b artanh(sin b) in a groove seen along the normal from afar.
TEST(OwnValues, OfObscurance) {
    const double half = 4.0 * 0.2 / pi * std::sqrt(0.5) * std::atanh(std::sqrt(0.5));
    const auto groove = view_named("groove", Projection::orthographic);
    const auto valley = view_named("valley", Projection::orthographic);
    EXPECT_NEAR(own_value(groove, ideal("alchemy"), 0, tolerance)->value, half, 1e-3);
    EXPECT_NEAR(own_value(valley, ideal("alchemy"), 0, tolerance)->value, 2.0 * half, 2e-3);
}

// The pixels' own share vanishes with their size.
TEST(OwnValues, FinerImagesComeNearerToTheLimit) {
    for (const OwnValue& own : own_values()) {
        if (own.integrand == nullptr || own.of_pixels) continue;
        const ClosedFormView view = view_named("wall 0.25", Projection::perspective);
        const Settings settings = with_method(Settings{}, own.name);
        const double limit = own_value(view, settings, 0, tolerance)->value;
        const double fine = std::abs(own_value(view, settings, 1025, tolerance)->value - limit);
        EXPECT_LT(fine, 0.004) << own.name;
    }
}

TEST(OwnValues, RefuseAnotherRadius) {
    const ClosedFormView view = view_named("pit", Projection::perspective);
    EXPECT_THROW((void)own_value(view, with_radius(Settings{}, 2.0F), 0, tolerance), std::invalid_argument);
    EXPECT_THROW((void)own_value_of("nonesuch"), std::invalid_argument);
}

}  // namespace gloam::effect::own_value_test
