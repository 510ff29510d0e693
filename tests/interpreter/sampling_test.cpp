// SPDX-License-Identifier: MIT
// What a sampler returns, against the equations of the Vulkan specification written out: for one row of
// texels, for the geometry of a cube, and for depths that are compared.
#include "interpreter/sampling.hpp"
#include "interpreter/internal/cube.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::sampling_test {

using backend::SampledHeader;
using backend::Word;
using backend::Wrap;
using interpreter::Precision;
using interpreter::SampledView;
using interpreter::SamplePoint;
using interpreter::internal::FaceTexel;
using numeric::Bounds;
using Vector = std::array<double, 3>;

constexpr std::array wraps{Wrap::repeat, Wrap::mirrored, Wrap::edge};

double counted(std::size_t texel) {
    return static_cast<double>(texel);
}

// An image: texel i of all levels has value(i), and each further component 10 more.
struct Image {
    std::vector<Word> words;

    explicit Image(const SampledHeader& header, const std::function<double(std::size_t)>& value = counted) {
        const auto as_words = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
        words.assign(as_words.begin(), as_words.end());
        for (std::size_t i = 0; i < backend::texels_before(header, header.levels); ++i) {
            const double first = value(i);
            for (std::size_t component = 0; component < backend::texel_words; ++component)
                words.push_back(
                    std::bit_cast<Word>(static_cast<float>(first + 10.0 * static_cast<double>(component))));
        }
    }
    [[nodiscard]] SampledView view(const backend::SamplerPrecision& precision = {.subtexel_bits = 8,
                                                                                 .level_bits = 8}) const {
        return interpreter::sampled_view_of(words, precision);
    }
};

SamplePoint at(double x, double y, double z = 0.0, double level = 0.0) {
    return {.at = {Bounds::point(x), Bounds::point(y), Bounds::point(z)}, .level = Bounds::point(level)};
}

double exact(const SampledView& view, const SamplePoint& point, std::size_t component = 0) {
    const Bounds bounds = interpreter::sampled(view, point, Precision::exact).at(component);
    EXPECT_EQ(bounds.low, bounds.high);
    return bounds.low;
}

Bounds permitted(const SampledView& view, const SamplePoint& point) {
    return interpreter::sampled(view, point, Precision::permitted)[0];
}

// Texel i of a row of `size` whose texels are 0, 1, 2 ...; beyond its ends by steps.
double row_texel(int i, int size, Wrap wrap) {
    while (wrap == Wrap::repeat && i < 0) i += size;
    while (wrap == Wrap::repeat && i >= size) i -= size;
    while (wrap == Wrap::mirrored && (i < 0 || i >= size)) i = i < 0 ? -1 - i : 2 * size - 1 - i;
    if (wrap == Wrap::edge) i = std::clamp(i, 0, size - 1);
    return i < 0 || i >= size ? 0.0 : i;
}

TEST(Sampling, LinearIsTheWeightedMeanOfTwoTexels) {
    for (const Wrap wrap : wraps) {
        const Image image({.width = 5, .linear = 1, .wrap = wrap});
        for (int step = -80; step < 120; ++step) {
            const double x = step / 40.0;
            const double place = x * 5.0 - 0.5;
            const auto first = static_cast<int>(std::floor(place));
            const double weight = place - first;
            const double want =
                (1.0 - weight) * row_texel(first, 5, wrap) + weight * row_texel(first + 1, 5, wrap);
            EXPECT_NEAR(exact(image.view(), at(x, 0.5)), want, 1e-12) << x << " " << static_cast<int>(wrap);
        }
    }
}

TEST(Sampling, NearestIsTheTexelAtThePlace) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::edge, Wrap::border}) {
        const Image image({.width = 5, .wrap = wrap});
        for (int step = -80; step < 120; ++step) {
            const double x = step / 40.0 + 0.001;
            EXPECT_EQ(exact(image.view(), at(x, 0.5)),
                      row_texel(static_cast<int>(std::floor(x * 5.0)), 5, wrap))
                << x << " " << static_cast<int>(wrap);
        }
    }
}

TEST(Sampling, ABorderIsZero) {
    const Image image({.width = 4, .height = 4, .linear = 1, .wrap = Wrap::border});
    EXPECT_EQ(exact(image.view(), at(0.0, 0.125), 1), 5.0)
        << "half of texel 0, which has 10, half of the border";
    EXPECT_EQ(exact(image.view(), at(-1.0, 0.5), 1), 0.0);
}

TEST(Sampling, RowsAndLayersFollowOneAnother) {
    const Image image({.width = 3, .height = 2, .linear = 1, .wrap = Wrap::edge});
    EXPECT_EQ(exact(image.view(), at(0.5 / 3, 0.75)), 3.0);
    EXPECT_EQ(exact(image.view(), at(1.0 / 3, 0.5)), 2.0) << "the mean of 0, 1, 3 and 4";
    EXPECT_EQ(exact(image.view(), at(1.0 / 3, 0.5), 2), 22.0);
    const Image layers({.width = 2, .height = 2, .depth = 3, .shape = backend::SampledShape::layers});
    for (const auto& [layer, want] : {std::pair(-3.0, 0.0), {0.4, 0.0}, {0.6, 4.0}, {2.0, 8.0}, {7.0, 8.0}})
        EXPECT_EQ(exact(layers.view(), at(0.25, 0.25, layer)), want) << layer;
    const Image volume(
        {.width = 2, .height = 2, .depth = 2, .shape = backend::SampledShape::three, .linear = 1});
    EXPECT_EQ(exact(volume.view(), at(0.25, 0.25, 0.5)), 2.0) << "between texels 0 and 4";
}

TEST(Sampling, LevelsAreMixedOrTheNearest) {
    const Image linear({.width = 4, .height = 4, .levels = 3, .linear = 1, .wrap = Wrap::edge});
    const SampledView view = linear.view();
    EXPECT_EQ(exact(view, at(0.125, 0.125, 0.0, 0.0)), 0.0);
    EXPECT_EQ(exact(view, at(0.25, 0.25, 0.0, 1.0)), 16.0);
    EXPECT_EQ(exact(view, at(0.25, 0.25, 0.0, 1.5)), 18.0) << "between 16 and 20";
    EXPECT_EQ(exact(view, at(0.25, 0.25, 0.0, 9.0)), 20.0);
    EXPECT_EQ(exact(view, at(0.125, 0.125, 0.0, -9.0)), 0.0);
    const Image nearest({.width = 4, .height = 4, .levels = 3});
    EXPECT_EQ(exact(nearest.view(), at(0.1, 0.1, 0.0, 0.4)), 0.0);
    EXPECT_EQ(exact(nearest.view(), at(0.1, 0.1, 0.0, 0.6)), 16.0);
    const Bounds either = permitted(nearest.view(), at(0.1, 0.1, 0.0, 0.5));
    EXPECT_EQ(either, (Bounds{0.0, 16.0, false})) << "a half goes either way";
}

TEST(Sampling, GradientsSelectTheLevel) {
    const Image image({.width = 4, .height = 4, .levels = 3, .linear = 1});
    const interpreter::Gradients gradients{.dx = {Bounds::point(0.5), Bounds::point(0.0)},  // two texels
                                           .dy = {Bounds::point(0.0), Bounds::point(0.25)}};
    const auto level = [&](Precision precision) {
        return interpreter::level_of(image.view(), {}, gradients, precision);
    };
    EXPECT_EQ(level(Precision::exact), Bounds::point(1.0));
    EXPECT_TRUE(level(Precision::permitted).contains(1.0));
    EXPECT_FALSE(level(Precision::permitted).contains(2.0));
}

TEST(Sampling, AGatherHasFourTexelsInItsOrder) {
    const Image image({.width = 3, .height = 3, .wrap = Wrap::edge});
    SamplePoint point = at(0.4, 0.4);  // between texels 0 and 1
    point.component = 1;
    const auto four = interpreter::sampled(image.view(), point, Precision::exact);
    EXPECT_THAT((std::array{four[0].low, four[1].low, four[2].low, four[3].low}),
                ElementsAre(13, 14, 11, 10));
}

TEST(Sampling, OffsetsAreInTexels) {
    const Image image({.width = 5, .wrap = Wrap::repeat});
    SamplePoint point = at(0.1, 0.5);
    point.offset = {2, 0, 0};
    EXPECT_EQ(exact(image.view(), point), 2.0);
    point.offset = {-1, 0, 0};
    EXPECT_EQ(exact(image.view(), point), 4.0);
}

// A driver of fixed-point weights, rounded down or to the nearest.
double quantized(const SampledView& view, double x, int bits, bool rounds) {
    const double place = std::ldexp(x * view.header.width - 0.5, bits);
    const double fixed = rounds ? std::nearbyint(place) : std::floor(place);
    const double first = std::floor(std::ldexp(fixed, -bits));
    const double weight = std::ldexp(fixed, -bits) - first;
    const int size = static_cast<int>(view.header.width);
    return (1.0 - weight) * row_texel(static_cast<int>(first), size, view.header.wrap) +
           weight * row_texel(static_cast<int>(first) + 1, size, view.header.wrap);
}

TEST(Sampling, PermittedAreFixedPointWeightsOfTheDevicesBits) {
    numeric::Random random(1);
    for (const Wrap wrap : wraps) {
        const Image image({.width = 5, .linear = 1, .wrap = wrap});
        const SampledView view = image.view();
        int coarser = 0;
        for (int i = 0; i < 2000; ++i) {
            const double x = random.uniform(-2.0, 3.0);
            const Bounds bounds = permitted(view, at(x, 0.5));
            EXPECT_TRUE(bounds.contains(exact(view, at(x, 0.5)))) << x;
            EXPECT_TRUE(bounds.contains(quantized(view, x, 8, true))) << x;
            EXPECT_TRUE(bounds.contains(quantized(view, x, 8, false))) << x;
            if (!bounds.contains(quantized(view, x, 4, false))) ++coarser;
            EXPECT_LT(bounds.high - bounds.low, 0.1 + 8.0 * (std::abs(exact(view, at(x, 0.5)) - 2.0) > 1.4))
                << x << ": it is no larger than the weights need, but where the ends of the row meet";
        }
        EXPECT_GT(coarser, 100) << "the device has 8 bits";
    }
}

TEST(Sampling, NearABorderOfTexelsBothAreTheNearest) {
    const Image image({.width = 4, .wrap = Wrap::edge});
    EXPECT_EQ(permitted(image.view(), at(0.5, 0.5)), (Bounds{1.0, 2.0, false}));
    EXPECT_EQ(permitted(image.view(), at(0.5009, 0.5)), (Bounds{1.0, 2.0, false})) << "0.0036 of a texel";
    EXPECT_EQ(permitted(image.view(), at(0.502, 0.5)), Bounds::point(2.0));
}

TEST(Sampling, WhatHasNoPlacePermitsEverything) {
    const Image image({.width = 4, .linear = 1});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SamplePoint nowhere = at(0.5, 0.5);
    nowhere.at[1] = Bounds::only_nan();
    EXPECT_TRUE(permitted(image.view(), nowhere).is_anything());
    EXPECT_TRUE(permitted(image.view(), at(3e38, 0.5)).is_anything());
    EXPECT_TRUE(permitted(image.view(), at(std::numeric_limits<double>::infinity(), 0.5)).is_anything());
    SamplePoint no_level = at(0.5, 0.5);
    no_level.level = Bounds{nan, nan, true};
    EXPECT_TRUE(permitted(image.view(), no_level).is_anything());
    const Bounds far = permitted(image.view(), at(1e8, 0.5));
    EXPECT_LE(far.low, 0.0) << "any texel";
    EXPECT_GE(far.high, 3.0);
}

TEST(Sampling, IntegersAreOneOfTheNearestTexels) {
    const Image image({.width = 4, .texel = backend::SampledTexel::integer, .wrap = Wrap::border});
    EXPECT_EQ(interpreter::sampled_texels(image.view(), at(0.5, 0.5), Precision::permitted).size(), 2U);
    const auto one = interpreter::sampled_texels(image.view(), at(0.6, 0.5), Precision::permitted);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0][0], 8U) << "the first word of texel 2";
    EXPECT_EQ(interpreter::sampled_texels(image.view(), at(-0.5, 0.5), Precision::exact)[0][0],
              interpreter::outside);
}

TEST(Sampling, WordsThatDisagreeAreRefused) {
    Image image({.width = 4, .levels = 3});
    image.words.pop_back();
    EXPECT_THROW((void)image.view(), std::invalid_argument);
    EXPECT_THROW((void)interpreter::sampled_view_of({}, {}), std::invalid_argument);
}

// The middle of a texel on the surface of the cube from -1 to 1, as the specification's table has it.
Vector middle(const FaceTexel& texel, double size) {
    const double s = (2.0 * static_cast<double>(texel.x) + 1.0) / size - 1.0;
    const double t = (2.0 * static_cast<double>(texel.y) + 1.0) / size - 1.0;
    const std::array<Vector, 6> faces{
        {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
    return faces.at(texel.face);
}

SamplePoint towards(const Vector& direction) {
    return at(direction[0], direction[1], direction[2]);
}

constexpr SampledHeader cube{.width = 4, .height = 4, .depth = 6, .shape = backend::SampledShape::cube};

TEST(Cube, ADirectionToTheMiddleOfATexelReadsIt) {
    const Image image(cube);
    const SampledView view = image.view();
    for (std::uint32_t face = 0; face < 6; ++face)
        for (long y = 0; y < 4; ++y)
            for (long x = 0; x < 4; ++x) {
                Vector to = middle({face, x, y}, 4.0);
                for (double& part : to) part *= 0.3;
                EXPECT_EQ(exact(view, towards(to)), face * 16.0 + static_cast<double>(y * 4 + x)) << face;
            }
}

TEST(Cube, ATexelBehindAnEdgeTouchesIt) {
    for (const long size : {1L, 2L, 5L})
        for (std::uint32_t face = 0; face < 6; ++face)
            for (long i = 0; i < size; ++i)
                for (const FaceTexel& beyond : {FaceTexel{face, -1, i}, FaceTexel{face, size, i},
                                                FaceTexel{face, i, -1}, FaceTexel{face, i, size}}) {
                    const auto found = interpreter::internal::folded(beyond, size);
                    ASSERT_TRUE(found);
                    EXPECT_NE(found->face, face);
                    const FaceTexel inside{face, std::clamp(beyond.x, 0L, size - 1),
                                           std::clamp(beyond.y, 0L, size - 1)};
                    const Vector a = middle(*found, static_cast<double>(size));
                    const Vector b = middle(inside, static_cast<double>(size));
                    double square = 0.0;
                    for (std::size_t k = 0; k < 3; ++k) square += (a.at(k) - b.at(k)) * (a.at(k) - b.at(k));
                    // Each is half a texel from the edge, at a right angle.
                    EXPECT_NEAR(std::sqrt(square), std::sqrt(2.0) / static_cast<double>(size), 1e-12);
                }
    EXPECT_FALSE(interpreter::internal::folded({0, -1, 4}, 4)) << "three faces meet at a corner";
}

TEST(Cube, AFilterIsContinuousAcrossEdgesAndCorners) {
    numeric::Random random(7);
    SampledHeader header = cube;
    header.linear = 1;
    const Image image(header, [&](std::size_t) { return random.uniform(0.0, 8.0); });
    const SampledView view = image.view();
    for (int k = 0; k < 500; ++k) {
        Vector to{random.uniform(-1.0, 1.0), 1.0, 1.0};
        if (k % 10 == 0) to[0] = 1.0;
        for (double& part : to) part *= random.below(2) == 0 ? 1.0 : -1.0;
        std::rotate(to.begin(), to.begin() + static_cast<long>(random.below(3)), to.end());
        const double first = exact(view, towards(to));
        for (double& part : to) part *= 1.0 + random.uniform(-1e-9, 1e-9);
        EXPECT_NEAR(exact(view, towards(to)), first, 1e-6);
        const Bounds bounds = permitted(view, towards(to));
        EXPECT_TRUE(bounds.contains(first)) << bounds.low << " " << bounds.high;
    }
}

TEST(Cube, AtTiesEitherFaceIsPermitted) {
    const Image image(cube, [](std::size_t i) { return counted(i / 16); });
    const SampledView view = image.view();
    const auto bounds = [&](const Vector& to) { return permitted(view, towards(to)); };
    EXPECT_TRUE(bounds({1, 1, 0.5}).contains(0.0) && bounds({1, 1, 0.5}).contains(2.0));
    EXPECT_EQ(bounds({1, 0.9, 0.5}).high, 0.0);
    EXPECT_EQ(exact(view, towards({1, 1, 1})), 4.0) << "z before y, y before x";
    EXPECT_EQ(exact(view, towards({-1, -1, 0.5})), 3.0);
}

TEST(Cube, WhatHasNoDirectionPermitsEverything) {
    const Image image(cube);
    const SampledView view = image.view();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Vector& to : {Vector{0, 0, 0}, Vector{infinity, 0, 0}, Vector{1e-40, 0, 1e-41}})
        EXPECT_EQ(permitted(view, towards(to)).high, infinity);
}

TEST(Cube, AGradientSelectsTheLevelByItsLengthOnTheFace) {
    SampledHeader header = cube;
    header.levels = 3;
    header.linear = 1;
    const Image image(header);
    const SampledView view = image.view();
    // On the face +z of a direction of length 2 along z, x / z changes by 1, and the coordinate by a half of
    // it: two texels.
    const interpreter::Gradients gradients{
        .dx = {Bounds::point(2.0), Bounds::point(0.0), Bounds::point(0.0)}};
    const Bounds level = interpreter::level_of(view, towards({0, 0, 2}), gradients, Precision::exact);
    EXPECT_NEAR(level.low, 1.0, 1e-12);
    // A change along the direction itself is none.
    const interpreter::Gradients deeper{.dx = {Bounds::point(0.0), Bounds::point(0.0), Bounds::point(2.0)}};
    EXPECT_EQ(interpreter::level_of(view, towards({0, 0, 2}), deeper, Precision::exact).high,
              -std::numeric_limits<double>::infinity());
}

TEST(Shadow, EachTexelIsComparedBeforeTheFilter) {
    const SampledHeader header{.width = 4, .texel = backend::SampledTexel::depth, .linear = 1};
    const Image image(header, [](std::size_t i) { return static_cast<double>(i) / 4.0; });  // 0 to 0.75
    const auto result = [&](double x, double reference, bool filters) {
        const SampledView view = image.view({.filters_depth = filters});
        SamplePoint point = at(x, 0.5);
        point.reference = Bounds::point(reference);
        EXPECT_EQ(view.header.compare, backend::Compare::less_equal);
        const double value = exact(view, point);
        const Bounds bounds = permitted(view, point);
        EXPECT_TRUE(bounds.contains(value));
        const bool mixes = value > 0.0 && value < 1.0;
        if (filters || mixes) {
            EXPECT_EQ(bounds.contains(0.7), !filters);
        }
        return value;
    };
    for (const bool filters : {true, false}) {
        EXPECT_EQ(result(0.5, 0.4, filters), 0.5) << "0.25 fails, 0.5 passes";
        EXPECT_EQ(result(0.4375, 0.4, filters), 0.25);
        EXPECT_EQ(result(0.5, 0.1, filters), 1.0);
        EXPECT_EQ(result(0.5, 0.6, filters), 0.0);
        EXPECT_EQ(result(0.625, 0.5, filters), 1.0) << "equal passes";
    }
}

}  // namespace gloam::sampling_test
