// SPDX-License-Identifier: MIT
// What follows, for every method, from the definition of its kernel: relations between its results on a rough
// view, seen with other samples, lengths and units.
#include "effect/settings.hpp"
#include "on_rough.hpp"

namespace gloam::method_kernels_test {

namespace rough = test::rough_view;
using Inputs = OnRough::Inputs;

// One test for each method, so that its kernel is compiled once.
class Kernels : public testing::TestWithParam<std::string> {
  protected:
    void the_length_of_the_normal_makes_no_difference() const;
    void another_angle_takes_other_samples() const;
    void the_unit_of_length_makes_no_difference() const;
    void steps_are_at_least_one() const;
    void a_part_of_a_unit_is_a_unit() const;
    void all_background_is_alike() const;

    const effect::MethodInfo& info = effect::method_named(GetParam());
    const OnRough method{GetParam(), 1};

    // That a change of the inputs leaves the results as they are.
    template <class Change>
    void expect_same_after(const Change& change) const {
        for (const Camera& camera : cameras) {
            const Surfaces surfaces{rough::surface(0, camera)};
            std::vector<Inputs> points = OnRough::points(camera);
            for (Inputs& point : points) change(point);
            expect_same(method(points, surfaces), method(camera, surfaces), camera, "changed");
        }
    }
};

void Kernels::the_length_of_the_normal_makes_no_difference() const {
    expect_same_after([](Inputs& point) { std::get<1>(point) *= 4.0F; });
}

// The points differ from pixel to pixel by that angle alone.
void Kernels::another_angle_takes_other_samples() const {
    for (const Camera& camera : cameras) {
        const Surfaces surfaces{rough::surface(0, camera)};
        std::vector<Inputs> turned = OnRough::points(camera);
        for (Inputs& point : turned) std::get<test::Samples>(point).angle += 0.7F;
        EXPECT_NE(method(turned, surfaces), method(camera, surfaces));
    }
}

// The settings of a method that are lengths.
Method scaled(Method method, float scale) {
    const std::vector<std::pair<const char*, float Method::*>> members{
        {"range", &Method::range},           {"epsilon", &Method::epsilon},
        {"intensity", &Method::intensity},   {"thickness", &Method::thickness},
        {"angle_bias", &Method::angle_bias}, {"feature_thickness", &Method::feature_thickness}};
    for (const auto& [name, member] : members)
        if (effect::setting_named(name).unit == "world units") method.*member *= scale;
    return method;
}

// World units are any units.
void Kernels::the_unit_of_length_makes_no_difference() const {
    if (test::calls(GetParam(), "gloam_fetch_prepared")) return;  // what is prepared has lengths in it
    for (const float scale : {0.0625F, 16.0F}) {
        for (const Camera& camera : cameras) {
            const Depths surface = rough::surface(0, camera);
            const Camera other{camera.orthographic ? camera.p00_p11 / scale : camera.p00_p11, camera.size,
                               camera.orthographic};
            std::vector<Inputs> points = OnRough::points(camera);
            for (auto& [position, normal, its_camera, samples, settings] : points) {
                position *= scale;
                its_camera = other;
                samples.radius *= scale;
                samples.bias *= scale;
                settings = scaled(settings, scale);
            }
            const Surfaces larger{[=](glm::ivec2 p) { return scale * surface(p); }};
            expect_same(method(points, larger), method(camera, {surface}), camera, std::to_string(scale));
        }
    }
}

void Kernels::steps_are_at_least_one() const {
    const Camera camera = rough::camera(false);
    const auto with_steps = [&](unsigned steps) {
        std::vector<Inputs> points = OnRough::points(camera);
        for (Inputs& point : points) std::get<Method>(point).steps = steps;
        return method(points, {rough::surface(0, camera)});
    };
    const test::Results one = with_steps(1);
    expect_same(with_steps(0), one, camera, "no step");
    if (info.takes_fewer || info.points == "disc") return;  // rejected taps are not taken
    for (const glm::vec2 sum : one) EXPECT_EQ(sum.y, static_cast<float>(effect::samples_taken(info, 16, 1)));
}

// A method takes whole units of samples, at least one.
void Kernels::a_part_of_a_unit_is_a_unit() const {
    for (const unsigned count : {1U, 3U, 7U, 13U}) {
        for (const Camera& camera : cameras) {
            std::vector<Inputs> asked = OnRough::points(camera);
            for (Inputs& point : asked) {
                test::Samples& samples = std::get<test::Samples>(point);
                samples.first = count * (samples.first / samples.count);
                samples.count = count;
            }
            std::vector<Inputs> whole = asked;
            for (Inputs& point : whole)
                std::get<test::Samples>(point).count =
                    effect::samples_taken(info, count, OnRough::settings.steps);
            const Surfaces surfaces{rough::surface(0, camera)};
            expect_same(method(asked, surfaces), method(whole, surfaces), camera, std::to_string(count));
        }
    }
}

// Any depth that is no surface is read as background, in views that reach the eye as well.
void Kernels::all_background_is_alike() const {
    for (const Camera& camera : cameras) {
        std::vector<Inputs> points = OnRough::points(camera);
        for (Inputs& point : points) std::get<test::Samples>(point).radius = 20.0F;
        const auto with_background = [&](float background) {
            const Depths surface = rough::surface(0, camera);
            return method(points,
                          {[=](glm::ivec2 p) { return surface(p) > 0.0F ? surface(p) : background; }});
        };
        const test::Results open = with_background(infinity);
        for (const float background : {0.0F, -0.0F, -1.0F, -infinity, nan})
            expect_same(with_background(background), open, camera, std::to_string(background));
    }
}

TEST_P(Kernels, FollowTheirDefinition) {
    the_length_of_the_normal_makes_no_difference();
    another_angle_takes_other_samples();
    the_unit_of_length_makes_no_difference();
    steps_are_at_least_one();
    a_part_of_a_unit_is_a_unit();
    all_background_is_alike();
}

INSTANTIATE_TEST_SUITE_P(All, Kernels, testing::ValuesIn(test::method_names()), test::parameter_name);

// A frame's spiral is turned by the radical inverse of its number.
class Spirals : public testing::TestWithParam<std::string> {};

TEST_P(Spirals, TurnFromFrameToFrame) {
    const OnRough method{GetParam(), 1};
    const Camera camera = rough::camera(false);
    const Surfaces surfaces{rough::surface(0, camera)};
    const auto at = [&](unsigned frame, double turns) {
        std::vector<Inputs> points = OnRough::points(camera);
        for (Inputs& point : points) {
            auto& samples = std::get<test::Samples>(point);
            samples.first = frame * samples.count;
            samples.angle += static_cast<float>(2.0 * std::numbers::pi * turns);
        }
        return method(points, surfaces);
    };
    for (const auto& [frame, turns] : {std::pair{1U, 0.5}, {2U, 0.25}, {3U, 0.75}, {4U, 0.125}}) {
        const test::Results got = at(frame, 0.0);
        const test::Results want = at(0, turns);
        std::size_t apart = 0;  // a tap at the border of a pixel may read its neighbour
        for (std::size_t i = 0; i < got.size(); ++i)
            apart += std::abs(got[i].x - want[i].x) > 1e-4F * got[i].y ? 1 : 0;
        EXPECT_LE(apart, got.size() / 20) << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Spirals, testing::Values("sao", "sao_chain"), test::parameter_name);

class PointsOfMethod : public testing::TestWithParam<std::string> {};

// A frame takes the points of its own samples of the shared sequence, each of them, and no others.
TEST_P(PointsOfMethod, AreThoseOfItsSamples) {
    const effect::MethodInfo& info = effect::method_named(GetParam());
    // Of two samples that are opposite points, or of two rays in opposite directions.
    constexpr unsigned steps = OnRough::settings.steps;
    const std::map<std::string, unsigned> several{{"crytek", 2}, {"hsao", 2 * steps}, {"unreal", 2 * steps}};
    const auto one = several.find(GetParam());
    const std::string unit =
        std::to_string(one == several.end() ? effect::unit_of(info, steps) : one->second);
    const std::string point = "vec3 gloam_" + info.points + "_point(uint index) {";
    const std::string head = "MethodValues values) {";
    const OnRough method(
        GetParam(), 1,
        test::Changes{
            {point, "uint own_first;\nuint own_count;\nuint own_taken = 0u;\nbool strange = false;\n" +
                        point +
                        "\nif (index - own_first < own_count) own_taken |= 1u << (index - own_first);\n"
                        "else strange = true;\n"},
            {head, head + "own_first = given.first / " + unit + "u + 1u;\nown_count = given.count / " + unit +
                       "u;\n"},
            {test::method_result, "if (strange || own_taken != (1u << own_count) - 1u) return vec2(-1.0);\n" +
                                      std::string(test::method_result)}});
    const Camera camera = rough::camera(false);
    for (const glm::vec2 sum : method(camera, {rough::surface(0, camera)})) EXPECT_GE(sum.x, 0.0F);
}

INSTANTIATE_TEST_SUITE_P(All, PointsOfMethod,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             // Of two slices of separable the pixels nearby have taken one.
                             return !method.points.empty() && method.name != "separable";
                         })),
                         test::parameter_name);

// Methods whose marches and taps begin beside the shaded pixel: what stands in it does not count.
class OwnPixels : public testing::TestWithParam<std::string> {};

TEST_P(OwnPixels, BlockNothing) {
    const OnRough method(GetParam(), 2);
    for (const Camera& camera : cameras) {
        const Surfaces surfaces{rough::surface(0, camera), rough::surface(1, camera)};
        for (std::size_t i = 0; i < OnRough::points(camera).size(); i += 5) {
            const auto nearer = [=](const Depths& surface, float depth) {
                return [=](glm::ivec2 p) { return p == rough::pixel_of(i) ? depth : surface(p); };
            };
            const Inputs point = OnRough::points(camera)[i];
            const float depth = -std::get<0>(point).z;
            EXPECT_EQ(
                method.at(point, {nearer(surfaces[0], depth - 0.3F), nearer(surfaces[1], depth - 0.1F)}),
                method.at(point, {nearer(surfaces[0], depth), nearer(surfaces[1], 0.0F)}))
                << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, OwnPixels,
                         testing::Values("bitmask", "disc_proxy", "gtao", "hbao", "hbao_study", "hsao",
                                         "mixture", "poisson", "sphere_proxy", "ssdo", "sweep", "unreal"),
                         test::parameter_name);

}  // namespace gloam::method_kernels_test
