// SPDX-License-Identifier: MIT
// What a sampler returns, against the equations of the Vulkan specification written out for one row of
// texels.
#include "interpreter/sampling.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::sampling_test {

using backend::SampledHeader;
using backend::Word;
using backend::Wrap;
using interpreter::Precision;
using interpreter::SampledView;
using interpreter::SamplePoint;
using numeric::Bounds;

constexpr std::array wraps{Wrap::repeat, Wrap::mirrored, Wrap::edge, Wrap::border};

// An image whose texels count: texel i of all levels has i, 10 + i, 20 + i, 30 + i.
struct Counting {
    std::vector<Word> words;

    explicit Counting(SampledHeader header) {
        const auto as_words = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
        words.assign(as_words.begin(), as_words.end());
        for (std::size_t i = 0; i < backend::texels_before(header, header.levels); ++i)
            for (std::size_t component = 0; component < backend::texel_words; ++component)
                words.push_back(std::bit_cast<Word>(static_cast<float>(i + 10 * component)));
    }
    [[nodiscard]] SampledView view() const {
        return interpreter::sampled_view_of(words, {.subtexel_bits = 8, .level_bits = 8});
    }
};

SamplePoint at(double x, double y, double level = 0.0) {
    return {.at = {Bounds::point(x), Bounds::point(y), Bounds::point(0.0)}, .level = Bounds::point(level)};
}

double exact(const SampledView& view, const SamplePoint& point, std::size_t component = 0) {
    const Bounds bounds = interpreter::sampled(view, point, Precision::exact).at(component);
    EXPECT_EQ(bounds.low, bounds.high);
    return bounds.low;
}

Bounds permitted(const SampledView& view, const SamplePoint& point, std::size_t component = 0) {
    return interpreter::sampled(view, point, Precision::permitted).at(component);
}

// Texel i of a row of `size` whose texels are 0, 1, 2 ...; beyond its ends by steps.
double row_texel(int i, int size, Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            while (i < 0) i += size;
            while (i >= size) i -= size;
            return i;
        case Wrap::mirrored:
            while (i < 0 || i >= size) i = i < 0 ? -1 - i : 2 * size - 1 - i;
            return i;
        case Wrap::edge:
            return std::clamp(i, 0, size - 1);
        default:
            return i < 0 || i >= size ? 0.0 : i;
    }
}

TEST(Sampling, LinearIsTheWeightedMeanOfTwoTexels) {
    for (const Wrap wrap : wraps) {
        const Counting image({.width = 5, .linear = 1, .wrap = wrap});
        for (int step = -80; step < 120; ++step) {
            const double x = step / 40.0;
            const double place = x * 5.0 - 0.5;
            const auto first = static_cast<int>(std::floor(place));
            const double weight = place - first;
            const double want =
                (1.0 - weight) * row_texel(first, 5, wrap) + weight * row_texel(first + 1, 5, wrap);
            if (wrap == Wrap::border) continue;  // in y the middle of one row: see below
            EXPECT_NEAR(exact(image.view(), at(x, 0.5)), want, 1e-12) << x << " " << static_cast<int>(wrap);
        }
    }
}

TEST(Sampling, NearestIsTheTexelAtThePlace) {
    for (const Wrap wrap : wraps) {
        const Counting image({.width = 5, .wrap = wrap});
        for (int step = -80; step < 120; ++step) {
            const double x = step / 40.0 + 0.001;
            EXPECT_EQ(exact(image.view(), at(x, 0.5)),
                      row_texel(static_cast<int>(std::floor(x * 5.0)), 5, wrap))
                << x << " " << static_cast<int>(wrap);
        }
    }
}

TEST(Sampling, ABorderIsZero) {
    const Counting image({.width = 4, .height = 4, .linear = 1, .wrap = Wrap::border});
    EXPECT_EQ(exact(image.view(), at(0.0, 0.125), 1), 5.0)
        << "half of texel 0, which has 10, half of the border";
    EXPECT_EQ(exact(image.view(), at(-1.0, 0.5), 1), 0.0);
}

TEST(Sampling, RowsAndLayersFollowOneAnother) {
    const Counting image({.width = 3, .height = 2, .linear = 1, .wrap = Wrap::edge});
    EXPECT_EQ(exact(image.view(), at(0.5 / 3, 0.75)), 3.0);
    EXPECT_EQ(exact(image.view(), at(1.0 / 3, 0.5)), 2.0) << "the mean of 0, 1, 3 and 4";
    EXPECT_EQ(exact(image.view(), at(1.0 / 3, 0.5), 2), 22.0);
    const Counting layers({.width = 2, .height = 2, .depth = 3, .shape = backend::SampledShape::layers});
    SamplePoint point = at(0.25, 0.25);
    for (const auto& [layer, want] : {std::pair(-3.0, 0.0), {0.4, 0.0}, {0.6, 4.0}, {2.0, 8.0}, {7.0, 8.0}}) {
        point.at[2] = Bounds::point(layer);
        EXPECT_EQ(exact(layers.view(), point), want) << layer;
    }
    const Counting volume(
        {.width = 2, .height = 2, .depth = 2, .shape = backend::SampledShape::three, .linear = 1});
    point.at[2] = Bounds::point(0.5);
    EXPECT_EQ(exact(volume.view(), point), 2.0) << "between texels 0 and 4";
}

TEST(Sampling, LevelsAreMixedOrTheNearest) {
    const Counting linear({.width = 4, .height = 4, .levels = 3, .linear = 1, .wrap = Wrap::edge});
    const SampledView view = linear.view();
    EXPECT_EQ(exact(view, at(0.125, 0.125, 0.0)), 0.0);
    EXPECT_EQ(exact(view, at(0.25, 0.25, 1.0)), 16.0);
    EXPECT_EQ(exact(view, at(0.25, 0.25, 1.5)), 18.0) << "between 16 and 20";
    EXPECT_EQ(exact(view, at(0.25, 0.25, 9.0)), 20.0);
    EXPECT_EQ(exact(view, at(0.125, 0.125, -9.0)), 0.0);
    const Counting nearest({.width = 4, .height = 4, .levels = 3});
    EXPECT_EQ(exact(nearest.view(), at(0.1, 0.1, 0.4)), 0.0);
    EXPECT_EQ(exact(nearest.view(), at(0.1, 0.1, 0.6)), 16.0);
    const Bounds either = permitted(nearest.view(), at(0.1, 0.1, 0.5));
    EXPECT_EQ(either, (Bounds{0.0, 16.0, false})) << "a half goes either way";
}

TEST(Sampling, GradientsSelectTheLevel) {
    const Counting image({.width = 4, .height = 4, .levels = 3, .linear = 1});
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
    const Counting image({.width = 3, .height = 3, .wrap = Wrap::edge});
    SamplePoint point = at(0.5, 0.5);
    point.at = {Bounds::point(0.4), Bounds::point(0.4), Bounds::point(0.0)};  // between texels 0 and 1
    point.component = 1;
    const auto four = interpreter::sampled(image.view(), point, Precision::exact);
    EXPECT_THAT((std::array{four[0].low, four[1].low, four[2].low, four[3].low}),
                ElementsAre(13, 14, 11, 10));
}

TEST(Sampling, OffsetsAreInTexels) {
    const Counting image({.width = 5, .wrap = Wrap::repeat});
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
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::edge}) {
        const Counting image({.width = 5, .linear = 1, .wrap = wrap});
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
    const Counting image({.width = 4, .wrap = Wrap::edge});
    EXPECT_EQ(permitted(image.view(), at(0.5, 0.5)), (Bounds{1.0, 2.0, false}));
    EXPECT_EQ(permitted(image.view(), at(0.5009, 0.5)), (Bounds{1.0, 2.0, false})) << "0.0036 of a texel";
    EXPECT_EQ(permitted(image.view(), at(0.502, 0.5)), Bounds::point(2.0));
}

TEST(Sampling, WhatHasNoPlacePermitsEverything) {
    const Counting image({.width = 4, .linear = 1});
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
    const Counting image({.width = 4, .texel = backend::SampledTexel::integer, .wrap = Wrap::border});
    EXPECT_EQ(interpreter::sampled_texels(image.view(), at(0.5, 0.5), Precision::permitted).size(), 2U);
    const auto one = interpreter::sampled_texels(image.view(), at(0.6, 0.5), Precision::permitted);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0][0], 8U) << "the first word of texel 2";
    EXPECT_EQ(interpreter::sampled_texels(image.view(), at(-0.5, 0.5), Precision::exact)[0][0],
              interpreter::outside);
}

TEST(Sampling, WordsThatDisagreeAreRefused) {
    Counting image({.width = 4, .levels = 3});
    image.words.pop_back();
    EXPECT_THROW((void)image.view(), std::invalid_argument);
    EXPECT_THROW((void)interpreter::sampled_view_of({}, {}), std::invalid_argument);
}

}  // namespace gloam::sampling_test
