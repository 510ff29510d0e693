// SPDX-License-Identifier: MIT
// What follows from the definitions of depth layers, for the methods that see them, and of rejected taps, for
// every method: relations between its results on a rough view whose surfaces change places.
#include "on_rough.hpp"

namespace gloam::method_layers_test {

namespace rough = test::rough_view;
using Inputs = OnRough::Inputs;

bool reads_layers(const effect::MethodInfo& method) {
    return calls(method.name, "gloam_fetch_layers");
}

class LayersOfMethod : public testing::TestWithParam<std::string> {};

// The image of the further layers need not exist for one layer.
TEST_P(LayersOfMethod, AreNotReadForOne) {
    const std::string fetch = "vec3 gloam_fetch_layers(ivec2 pixel) {";
    const OnRough method(GetParam(), 1,
                         test::Changes{{fetch, "bool read = false;\n" + fetch + "\nread = true;\n"},
                                       {test::method_result, "if (read) return vec2(-1.0);\n" +
                                                                 std::string(test::method_result)}});
    const Camera camera = rough::camera(false);
    for (const glm::vec2 sum : method(camera, {rough::surface(0, camera)})) EXPECT_GE(sum.x, 0.0F);
}

TEST_P(LayersOfMethod, BeyondThoseAskedForDoNotCount) {
    for (const int layers : {2, 3}) {
        const OnRough method(GetParam(), layers);
        for (const Camera& camera : cameras) {
            Surfaces surfaces;
            for (std::uint32_t i = 0; i < 4; ++i) surfaces.push_back(rough::surface(i, camera));
            const Results all = method(camera, surfaces);
            surfaces.resize(static_cast<std::size_t>(layers));
            expect_same(all, method(camera, surfaces), camera, std::to_string(layers) + " layers");
        }
    }
}

// A surface blocks from whichever layer it is in; one more time the same surface blocks nothing more.
TEST_P(LayersOfMethod, ASurfaceCountsFromAnyLayerAndOnce) {
    const OnRough method(GetParam(), 4);
    for (const Camera& camera : cameras) {
        const Depths first = rough::surface(0, camera);
        const Depths second = rough::surface(1, camera);
        const Results alone = method(camera, {first});
        const Results both = method(camera, {first, second});
        EXPECT_NE(both, alone);
        expect_same(method(camera, {first, rough::none, second}), both, camera, "in the third layer");
        expect_same(method(camera, {first, rough::none, rough::none, second}), both, camera, "in the fourth");
        expect_same(method(camera, {first, first, first, first}), alone, camera, "four times");
        expect_same(method(camera, {first, first, second, second}), both, camera, "each twice");
    }
}

INSTANTIATE_TEST_SUITE_P(All, LayersOfMethod, testing::ValuesIn(test::method_names(reads_layers)),
                         test::parameter_name);

// Where of each tap the surface counts that blocks most.
class OrderOfLayers : public testing::TestWithParam<std::string> {};

TEST_P(OrderOfLayers, MakesNoDifference) {
    const OnRough method(GetParam(), 4);
    for (const Camera& camera : cameras) {
        Surfaces surfaces;
        for (std::uint32_t i = 0; i < 4; ++i) surfaces.push_back(rough::surface(i, camera));
        const Results known = method(camera, surfaces);
        for (int i = 0; i < 3; ++i) {
            std::ranges::rotate(surfaces, surfaces.begin() + 1);
            expect_same(method(camera, surfaces), known, camera, "rotated");
        }
        std::ranges::reverse(surfaces);
        expect_same(method(camera, surfaces), known, camera, "reversed");
    }
}

// Not for horizons, which count each rise at its own distance.
INSTANTIATE_TEST_SUITE_P(All, OrderOfLayers,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             return reads_layers(method) && method.name != "dual_resolution";
                         })),
                         test::parameter_name);

// Surfaces too far in front do not count (CS-REJ): a slice goes on without them, a point or tap is not taken.
class Rejection : public testing::TestWithParam<std::string> {
  protected:
    static constexpr float farthest = 0.3F;
    // separable: the mean over its line has no part in what is rejected.
    const bool level = GetParam() == std::string("separable");
    const OnRough every{GetParam(), 2, infinity, level};
    const OnRough near{GetParam(), 2, farthest, level};
    const bool of_slices = level || effect::method_named(GetParam()).unit == effect::SampleUnit::slice;

    static bool rejects(float depth, float tap) { return tap > 0.0F && depth - tap > farthest; }
    // The two surfaces without what is rejected at a point. A tap is rejected with all its layers.
    [[nodiscard]] Surfaces without_rejected(float depth, const Surfaces& all) const {
        const auto seen = [=, this](std::size_t layer, glm::ivec2 p) {
            const float own = all[layer](p);
            return rejects(depth, of_slices ? own : all[0](p)) ? 0.0F : own;
        };
        return {[=](glm::ivec2 p) { return seen(0, p); }, [=](glm::ivec2 p) { return seen(1, p); }};
    }

    // Rejected where the surface is not, and nowhere else.
    [[nodiscard]] static Depths contrary(float depth, const Depths& surface) {
        return [=](glm::ivec2 p) { return rejects(depth, surface(p)) ? depth : depth - 2.0F * farthest; };
    }
};

TEST_P(Rejection, WhatIsTooFarInFrontDoesNotCount) {
    for (const Camera& camera : cameras) {
        const Surfaces all{rough::surface(0, camera), rough::surface(1, camera)};
        float left_out = 0.0F;
        for (std::size_t i = 0; i < every.points(camera).size(); i += 7) {
            const auto input = every.points(camera)[i];
            const float depth = -std::get<0>(input).z;
            const glm::vec2 got = near.at(input, all);
            const glm::vec2 want = every.at(input, without_rejected(depth, all));
            EXPECT_NEAR(got.x, want.x, of_slices ? 0.0F : 1e-5F) << i;
            left_out += every.at(input, all).x - want.x;
            if (of_slices)
                EXPECT_EQ(got.y, want.y);
            else
                EXPECT_EQ(got.y + near.at(input, {contrary(depth, all[0])}).y, want.y) << i;
        }
        EXPECT_GT(left_out, 0.1F);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Rejection,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             return method.name != "aksoy_phaneuf_two" &&
                                    calls(method.name, "gloam_tap_rejected");
                         })),
                         test::parameter_name);

class NoRejection : public testing::TestWithParam<std::string> {};

TEST_P(NoRejection, WhatIsFarInFrontCountsLikeAnythingElse) {
    const OnRough every{GetParam(), 1};
    const OnRough near{GetParam(), 1, 0.3F};
    for (const Camera& camera : cameras) {
        const Surfaces surface{rough::surface(0, camera)};
        expect_same(near(camera, surface), every(camera, surface), camera, "rejection");
    }
}

INSTANTIATE_TEST_SUITE_P(All, NoRejection,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             return !calls(method.name, "gloam_tap_rejected");
                         })),
                         test::parameter_name);

// The sum of another method's results at two radii, each without what is too far in front.
TEST(RejectionAtTwoRadii, IsThatOfEachRadius) {
    constexpr float farthest = 0.3F;
    const OnRough two("aksoy_phaneuf_two", 2, farthest);
    const OnRough one("aksoy_phaneuf", 2, farthest);
    for (const Camera& camera : cameras) {
        const Surfaces all{rough::surface(0, camera), rough::surface(1, camera)};
        for (std::size_t i = 0; i < OnRough::points(camera).size(); i += 7) {
            Inputs input = OnRough::points(camera)[i];
            const glm::vec2 got = two.at(input, all);
            auto& samples = std::get<test::Samples>(input);
            samples.first /= 2;
            samples.count /= 2;
            float sum = 0.0F;
            for (const float share : {1.0F, 0.25F}) {
                samples.radius = share * rough::radius;
                const glm::vec2 part = one.at(input, all);
                sum += part.y > 0.0F ? part.x / part.y : 0.0F;
            }
            EXPECT_NEAR(got.x, got.y * std::min(sum, 1.0F), 1e-5F) << i;
        }
    }
}

// A tunnel whose sides rise beside the point; a fence hangs in front of them, too far to block anything. A
// fence whose back is seen blocks nothing behind it: what the layer behind the back shows is all there is.
TEST(DepthLayers, BehindTheBackOfAnObjectOnlyTheNextOneBlocks) {
    const test::Gathers gathers(3);
    const check::Function<Gather> gather = gathers["hemisphere"];
    const auto beside = [](float sides, float middle) -> test::Depths {
        return [=](glm::ivec2 p) { return std::abs(p.x - 32) > 4 ? sides : middle; };
    };
    // The mean of 256 samples at the middle of a floor at depth 5.
    const auto mean = [&](const test::Depths& first, const test::Depths& second, const test::Depths& third) {
        const Camera camera{glm::vec2(0.5F, -0.5F), glm::ivec2(65), true};
        check::ImageSet images = test::view_of(camera.size, first);
        images.insert_or_assign("gloam_fetch_layers",
                                check::make_image<glm::vec3>(camera.size, [&](glm::ivec2 p) {
                                    return glm::vec3(second(p), third(p), 0);
                                }));
        const test::Samples samples{.radius = 1.0F, .bias = 1e-4F, .angle = 0.0F, .first = 0, .count = 256};
        const glm::vec2 sum = gather.with_images(
            images, {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), camera, samples, test::Method{.range = 1.5F}});
        return static_cast<double>(sum.x / sum.y);
    };
    const double seen = mean(beside(4.6F, 5.0F), rough::none, rough::none);
    const double open = mean(beside(5.0F, 5.0F), rough::none, rough::none);
    ASSERT_GT(seen, open + 0.005);
    const test::Depths fenced = beside(1.0F, 5.0F);
    const test::Depths back_of_fence = beside(-1.1F, 0.0F);
    EXPECT_NEAR(mean(fenced, back_of_fence, beside(4.6F, 0.0F)), seen, 1e-6);
    EXPECT_NEAR(mean(fenced, back_of_fence, beside(5.0F, 5.0F)), open, 1e-6);
}

}  // namespace gloam::method_layers_test
