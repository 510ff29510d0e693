// SPDX-License-Identifier: MIT
// Samplers of cubes and of depths, against the geometry of a cube and a comparison written out.
#include "interpreter/internal/cube.hpp"
#include "interpreter/sampling.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::cube_test {

using backend::SampledHeader;
using backend::SampledShape;
using backend::SampledTexel;
using backend::Word;
using interpreter::Precision;
using interpreter::SampledView;
using interpreter::SamplePoint;
using interpreter::internal::FaceTexel;
using numeric::Bounds;
using Vector = std::array<double, 3>;

// The middle of a texel on the surface of the cube from -1 to 1, as the specification's table has it.
Vector middle(const FaceTexel& texel, double size) {
    const double s = (2.0 * static_cast<double>(texel.x) + 1.0) / size - 1.0;
    const double t = (2.0 * static_cast<double>(texel.y) + 1.0) / size - 1.0;
    switch (texel.face) {
        case 0:
            return {1, -t, -s};
        case 1:
            return {-1, -t, s};
        case 2:
            return {s, 1, t};
        case 3:
            return {s, -1, -t};
        case 4:
            return {s, -t, 1};
        default:
            return {-s, -t, -1};
    }
}

SamplePoint towards(const Vector& direction, double level = 0.0) {
    return {.at = {Bounds::point(direction[0]), Bounds::point(direction[1]), Bounds::point(direction[2]),
                   Bounds::point(0.0)},
            .level = Bounds::point(level)};
}

// Words of an image whose texels are value(i).
template <class Value>
std::vector<Word> image_of(const SampledHeader& header, Value value) {
    const auto as_words = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
    std::vector<Word> words(as_words.begin(), as_words.end());
    for (std::size_t i = 0; i < backend::texels_before(header, header.levels); ++i)
        for (std::size_t component = 0; component < backend::texel_words; ++component)
            words.push_back(std::bit_cast<Word>(static_cast<float>(value(i))));
    return words;
}

constexpr SampledHeader cube{.width = 4, .height = 4, .depth = 6, .shape = SampledShape::cube};

double exact(const SampledView& view, const SamplePoint& point) {
    return interpreter::sampled(view, point, Precision::exact)[0].low;
}

TEST(Cube, ADirectionToTheMiddleOfATexelReadsIt) {
    const std::vector<Word> words = image_of(cube, [](std::size_t i) { return i; });
    const SampledView view = interpreter::sampled_view_of(words, {});
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
    const std::vector<Word> words = image_of(header, [&](std::size_t) { return random.uniform(0.0, 8.0); });
    const SampledView view = interpreter::sampled_view_of(words, {});
    for (int k = 0; k < 500; ++k) {
        Vector to{random.uniform(-1.0, 1.0), 1.0, 1.0};
        if (k % 10 == 0) to[0] = 1.0;
        for (double& part : to) part *= random.below(2) == 0 ? 1.0 : -1.0;
        std::rotate(to.begin(), to.begin() + static_cast<long>(random.below(3)), to.end());
        const double first = exact(view, towards(to));
        for (double& part : to) part *= 1.0 + random.uniform(-1e-9, 1e-9);
        EXPECT_NEAR(exact(view, towards(to)), first, 1e-6);
        const Bounds bounds = interpreter::sampled(view, towards(to), Precision::permitted)[0];
        EXPECT_TRUE(bounds.contains(first)) << bounds.low << " " << bounds.high;
    }
}

TEST(Cube, AtTiesEitherFaceIsPermitted) {
    const std::vector<Word> words = image_of(cube, [](std::size_t i) { return i / 16; });
    const SampledView view = interpreter::sampled_view_of(words, {});
    const auto bounds = [&](const Vector& to) {
        return interpreter::sampled(view, towards(to), Precision::permitted)[0];
    };
    EXPECT_TRUE(bounds({1, 1, 0.5}).contains(0.0) && bounds({1, 1, 0.5}).contains(2.0));
    EXPECT_EQ(bounds({1, 0.9, 0.5}).high, 0.0);
    EXPECT_EQ(exact(view, towards({1, 1, 1})), 4.0) << "z before y, y before x";
    EXPECT_EQ(exact(view, towards({-1, -1, 0.5})), 3.0);
}

TEST(Cube, WhatHasNoDirectionPermitsEverything) {
    const std::vector<Word> words = image_of(cube, [](std::size_t i) { return i; });
    const SampledView view = interpreter::sampled_view_of(words, {});
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Vector& to : {Vector{0, 0, 0}, Vector{infinity, 0, 0}, Vector{1e-40, 0, 1e-41}})
        EXPECT_EQ(interpreter::sampled(view, towards(to), Precision::permitted)[0].high, infinity);
}

TEST(Cube, AGradientSelectsTheLevelByItsLengthOnTheFace) {
    SampledHeader header = cube;
    header.levels = 3;
    header.linear = 1;
    const std::vector<Word> words = image_of(header, [](std::size_t) { return 0.0; });
    const SampledView view = interpreter::sampled_view_of(words, {});
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
    const SampledHeader header{.width = 4, .texel = SampledTexel::depth, .linear = 1};
    const std::vector<Word> words =
        image_of(header, [](std::size_t i) { return static_cast<double>(i) / 4.0; });  // 0 to 0.75
    const auto result = [&](double x, double reference, bool filters) {
        const SampledView view = interpreter::sampled_view_of(words, {.filters_depth = filters});
        SamplePoint point{.at = {Bounds::point(x), Bounds::point(0.5)},
                          .reference = Bounds::point(reference)};
        EXPECT_EQ(view.header.compare, backend::Compare::less_equal);
        const double value = exact(view, point);
        const Bounds bounds = interpreter::sampled(view, point, Precision::permitted)[0];
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

}  // namespace gloam::cube_test
