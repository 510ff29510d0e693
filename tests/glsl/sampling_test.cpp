// SPDX-License-Identifier: MIT
// Elementary functions, sequences of samples and what is made of them, beyond their known values.
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::sampling_test {

using check::Function;

constexpr double pi = std::numbers::pi;

class Numeric : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

TEST_F(Numeric, TurnsAreOddAndEven) {
    const Function<glm::vec2(float)> f(lab, "gloam/numeric/sincos.glsl", "gloam_sincos_turns");
    for (const float t : {0.1F, 0.3F, 0.77F, 12.34F}) {
        EXPECT_EQ(f(-t).x, f(t).x);
        EXPECT_EQ(f(-t).y, -f(t).y);
    }
}

TEST_F(Numeric, DirectionsOfVectorsOfAnyLength) {
    const Function<float(float, float)> f(lab, "gloam/numeric/inverse_trigonometry.glsl", "gloam_atan2");
    for (const float scale : {1e-37F, 1e-10F, 1.0F, 1e37F}) {
        for (const float a : {0.1F, 0.7F, 1.0F, 2.0F, 3.0F, -0.1F, -1.0F, -2.5F}) {
            EXPECT_NEAR(f(scale * std::sin(a), scale * std::cos(a)), a, 4e-7) << a << " at " << scale;
        }
    }
}

// T28.
TEST_F(Numeric, TheCubicOfTheArcCosineIsSoFarOff) {
    const Function<float(float)> f(lab, "gloam/numeric/acos_approximation.glsl", "gloam_acos_cubic");
    std::vector<std::tuple<float>> inputs;
    for (int i = 0; i <= 20000; ++i) inputs.emplace_back(static_cast<float>(i) / 10000.0F - 1.0F);
    const std::vector<float> results = f(inputs);
    double worst = 0.0;
    for (std::size_t i = 0; i < results.size(); ++i)
        worst = std::max(worst, std::abs(double{results[i]} - std::acos(double{std::get<0>(inputs[i])})));
    EXPECT_NEAR(worst, 0.178758, 1e-5);
}

// Vulkan lets a driver reorder what is not `precise`: the reductions of arguments must not be undone by it.
// Only drawn angles: one float below half a turn may be reduced to either side, and the hull of both bounds
// nothing.
TEST_F(Numeric, WhateverOrderADriverTakesTheErrorIsBounded) {
    const check::Lab shipped(
        {.device = std::string(check::interpreter_name), .include_roots = {GLOAM_GLSL_DIR}});
    const std::string forward = "gloam/numeric/sincos.glsl";
    const std::string inverse = "gloam/numeric/inverse_trigonometry.glsl";
    const check::RunOptions options{.inputs = 1024};
    const auto error = [&](const check::Answer& answer) {
        EXPECT_EQ(answer.verdict, check::Verdict::rules);
        EXPECT_EQ(answer.unbounded, 0U) << answer.function;
        return answer.guarantee.absolute;
    };
    const check::Values cosine = check::uniform(-1, 1).only_as_drawn();
    EXPECT_LT(error(check::Function<glm::vec2(float)>(shipped, forward, "gloam_sincos_turns")
                        .check_rules({check::uniform(-4, 4).only_as_drawn()}, options)),
              4e-6);
    EXPECT_LT(error(check::Function<glm::vec2(float)>(shipped, forward, "gloam_sincos")
                        .check_rules({check::uniform(-100, 100).only_as_drawn()}, options)),
              4e-6);
    EXPECT_LT(
        error(check::Function<float(float)>(shipped, inverse, "gloam_acos").check_rules({cosine}, options)),
        2e-4);
    EXPECT_LT(error(check::Function<float(float, float)>(shipped, inverse, "gloam_atan2")
                        .check_rules({cosine, cosine}, options)),
              2e-4);
}

class Sampling : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    // The 3-D Halton points 1 ... count, from the device.
    std::vector<glm::vec3> halton(unsigned count) const {
        const Function<glm::vec3(unsigned)> point(lab, "gloam/sampling/halton.glsl", "gloam_halton_3d");
        std::vector<std::tuple<unsigned>> indices;
        for (unsigned i = 1; i <= count; ++i) indices.emplace_back(i);
        return point(indices);
    }

    // A map of one argument, for all of them at once.
    template <class Result, class Argument>
    std::vector<Result> map(const std::string& file, const std::string& function,
                            const std::vector<Argument>& arguments) const {
        const Function<Result(Argument)> kernel(lab, "gloam/sampling/" + file, function);
        return kernel(std::vector<std::tuple<Argument>>(arguments.begin(), arguments.end()));
    }
};

// Unit vectors, some of them where the tangent frame's sign changes.
std::vector<glm::vec3> directions(std::size_t count) {
    numeric::Random random(7);
    std::vector<glm::vec3> all{{0, 0, 1},
                               {0, 0, -1},
                               {1, 0, 0},
                               {0, 1, 0},
                               {1, 0, -0.0F},
                               {0.6F, 0.8F, 1e-20F},
                               {0.6F, 0.8F, -1e-20F},
                               {1e-4F, -1e-4F, -1}};
    while (all.size() < count) {
        const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (glm::length(v) > 0.1) all.emplace_back(glm::normalize(v));
    }
    return all;
}

// The mean of the values must be within four standard errors of the expected one.
void expect_mean(const std::vector<double>& values, double expected, double deviation) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    const auto count = static_cast<double>(values.size());
    EXPECT_NEAR(sum / count, expected, 4.0 * deviation / std::sqrt(count));
}

TEST_F(Sampling, RadicalInverseHasTheTableValues) {
    const std::array<double, 10> base2{1. / 2, 1. / 4, 3. / 4,  1. / 8,  5. / 8,
                                       3. / 8, 7. / 8, 1. / 16, 9. / 16, 5. / 16};
    const std::array<double, 10> base3{1. / 3, 2. / 3, 1. / 9, 4. / 9,  7. / 9,
                                       2. / 9, 5. / 9, 8. / 9, 1. / 27, 10. / 27};
    const std::array<double, 10> base5{1. / 5,  2. / 5,   3. / 5,   4. / 5,   1. / 25,
                                       6. / 25, 11. / 25, 16. / 25, 21. / 25, 2. / 25};
    const std::vector<glm::vec3> points = halton(10);
    const Function<float(unsigned, unsigned)> inverse(lab, "gloam/sampling/radical_inverse.glsl",
                                                      "gloam_radical_inverse");
    for (unsigned i = 0; i < 10; ++i) {
        EXPECT_EQ(points[i].x, static_cast<float>(base2[i])) << "index " << i + 1;
        EXPECT_LE(numeric::ulp_error(points[i].y, base3[i]), 1.0) << "index " << i + 1;
        EXPECT_LE(numeric::ulp_error(points[i].z, base5[i]), 1.0) << "index " << i + 1;
        EXPECT_EQ(inverse(i + 1, 2U), static_cast<float>(base2[i])) << "index " << i + 1;
    }
}

TEST_F(Sampling, RadicalInverseStaysBelowOne) {
    const Function<float(unsigned, unsigned)> inverse(lab, "gloam/sampling/radical_inverse.glsl",
                                                      "gloam_radical_inverse");
    std::vector<std::tuple<unsigned, unsigned>> inputs;
    for (const unsigned base : {2U, 3U, 5U, 7U, 1625U, 4096U}) {
        // All digits are base - 1: the largest inverse with so many digits.
        for (unsigned long power = base; power <= 16777216UL; power *= base) {
            inputs.emplace_back(static_cast<unsigned>(power - 1), base);
        }
    }
    for (const float value : inverse(inputs)) {
        EXPECT_LT(value, 1.0F);
        EXPECT_GE(value, 0.5F);
    }
}

// As printed, sqrt(r - zeta_z) is NaN where r < zeta_z, and |s| is not r.
TEST_F(Sampling, HemisphereSamplesAreFiniteUpwardAndOfTheirRadius) {
    const std::vector<glm::vec3> zeta = halton(1024);
    for (const char* function : {"gloam_hemisphere_cosine", "gloam_hemisphere_uniform"}) {
        const auto samples = map<glm::vec3>("hemisphere.glsl", function, zeta);
        for (std::size_t i = 0; i < zeta.size(); ++i) {
            EXPECT_NEAR(glm::length(glm::dvec3(samples[i])), zeta[i].y, 1e-6) << function;
            EXPECT_GE(samples[i].z, 0.0F) << function;
        }
    }
}

TEST_F(Sampling, MeanCosineTellsTheDirectionsApart) {
    const std::vector<glm::vec3> zeta = halton(4096);
    const auto cosines = [&](const char* function) {
        std::vector<double> all;
        for (const glm::dvec3 s : map<glm::vec3>("hemisphere.glsl", function, zeta)) {
            all.push_back(s.z / glm::length(s));
        }
        return all;
    };
    expect_mean(cosines("gloam_hemisphere_cosine"), 2.0 / 3, std::sqrt(1.0 / 2 - 4.0 / 9));
    expect_mean(cosines("gloam_hemisphere_uniform"), 1.0 / 2, std::sqrt(1.0 / 12));
}

TEST_F(Sampling, DiscSamplesAreUniformOnTheDisc) {
    std::vector<glm::vec2> zeta;
    for (const glm::vec3 point : halton(4096)) zeta.emplace_back(point.x, point.y);
    std::vector<double> radii, xs, ys;
    for (const glm::dvec2 s : map<glm::vec2>("disc.glsl", "gloam_disc_sample", zeta)) {
        radii.push_back(glm::length(s));
        xs.push_back(s.x);
        ys.push_back(s.y);
    }
    expect_mean(radii, 2.0 / 3, std::sqrt(1.0 / 18));
    expect_mean(xs, 0.0, 0.5);
    expect_mean(ys, 0.0, 0.5);
}

TEST_F(Sampling, TangentFramesAreOrthonormalAndRightHanded) {
    const std::vector<glm::vec3> normals = directions(4096);
    const auto frames = map<glm::mat3>("tangent_frame.glsl", "gloam_tangent_frame", normals);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dmat3 frame(frames[i]);
        const glm::dmat3 product = glm::transpose(frame) * frame;
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r ? 1.0 : 0.0, 2e-6);
        }
        EXPECT_NEAR(glm::determinant(frame), 1.0, 2e-6);
        EXPECT_LT(glm::distance(frame[2], glm::normalize(glm::dvec3(normals[i]))), 1e-6);
    }
}

TEST_F(Sampling, TangentFrameOfNoDirectionHasTheAxesOfTheImage) {
    const Function<glm::mat3(glm::vec3)> frame(lab, "gloam/sampling/tangent_frame.glsl",
                                               "gloam_tangent_frame");
    EXPECT_EQ(frame(glm::vec3(0.0F)), glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0)));
    EXPECT_TRUE(std::isnan(frame(glm::vec3(0.0F, NAN, 1.0F))[0][1]));
}

TEST_F(Sampling, RotationKeepsLengthAndAngleToTheNormal) {
    const Function<glm::vec3(glm::vec3, float)> rotate(lab, "gloam/sampling/rotation.glsl",
                                                       "gloam_rotate_hemisphere");
    numeric::Random random(11);
    std::vector<std::tuple<glm::vec3, float>> inputs;
    for (const glm::vec3 s : directions(2048)) {
        inputs.emplace_back(s * static_cast<float>(random.unit()),
                            static_cast<float>(random.uniform(-100, 100)));
    }
    const std::vector<glm::vec3> rotated = rotate(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto& [s, angle] = inputs[i];
        EXPECT_NEAR(glm::length(glm::dvec3(rotated[i])), glm::length(glm::dvec3(s)), 1e-6);
        EXPECT_EQ(rotated[i].z, s.z);
        // And by the angle asked for, counter-clockwise.
        const double expected = std::atan2(s.y, s.x) + static_cast<double>(angle);
        const double radius = glm::length(glm::dvec2(s));
        EXPECT_NEAR(rotated[i].x, radius * std::cos(expected), 2e-6);
        EXPECT_NEAR(rotated[i].y, radius * std::sin(expected), 2e-6);
    }
}

TEST_F(Sampling, HashRotationIsExactForLargePixels) {
    const Function<float(glm::ivec2)> rotation(lab, "gloam/sampling/hash_rotation.glsl",
                                               "gloam_hash_rotation");
    double worst_in_float = 0.0;
    for (const glm::ivec2 pixel : {glm::ivec2(7, 3), glm::ivec2(1919, 1079), glm::ivec2(8191, 8191)}) {
        const auto hash = static_cast<unsigned>((3 * pixel.x) ^ (pixel.y + pixel.x * pixel.y));
        const double exact = std::fmod(10.0 * hash, 2 * pi);
        EXPECT_NEAR(rotation(pixel), exact, 1e-6);
        const double in_float = std::fmod(static_cast<double>(10.0F * static_cast<float>(hash)), 2 * pi);
        worst_in_float = std::max(worst_in_float, std::abs(in_float - exact));
    }
    EXPECT_GT(worst_in_float, 1e-2);  // what the formula gives in float, reduced without any further error
    const float wrapped = rotation(glm::ivec2(-5, 2147483647));
    EXPECT_TRUE(wrapped >= 0.0F && wrapped < 2 * pi);
}

TEST_F(Sampling, SpiralTapsLieOnTheirRadiiAndAngles) {
    const Function<glm::vec2(int, int, int)> tap(lab, "gloam/sampling/spiral.glsl", "gloam_spiral_point");
    for (int i = 0; i < 9; ++i) {
        const double radius = (i + 0.5) / 9;
        const glm::dvec2 s = tap(i, 9, 7);
        EXPECT_NEAR(s.x, radius * std::cos(2 * pi * radius * 7), 1e-6);
        EXPECT_NEAR(s.y, radius * std::sin(2 * pi * radius * 7), 1e-6);
    }
}

TEST_F(Sampling, LiftedDiscPointsAreCosineWeighted) {
    std::vector<glm::vec2> zeta;
    for (const glm::vec3 point : halton(4096)) zeta.emplace_back(point.x, point.y);
    const auto discs = map<glm::vec2>("disc.glsl", "gloam_disc_sample", zeta);
    std::vector<double> heights;
    for (const glm::dvec3 s : map<glm::vec3>("poisson.glsl", "gloam_hemisphere_lift", discs)) {
        EXPECT_NEAR(glm::length(s), 1.0, 1e-6);
        heights.push_back(s.z);
    }
    expect_mean(heights, 2.0 / 3, std::sqrt(1.0 / 2 - 4.0 / 9));
}

TEST_F(Sampling, IssaoOffsets) {
    const std::string file = "gloam/sampling/issao_offset.glsl";
    const Function<glm::vec2(glm::vec2, float)> polar(lab, file, "gloam_issao_offset_polar");
    const Function<glm::vec2(glm::vec2, float)> printed(lab, file, "gloam_issao_offset_printed");
    double longest = 0.0;
    double sum = 0.0;
    int moved = 0;
    constexpr int steps = 100;
    for (int i = 0; i < steps; ++i) {
        std::vector<std::tuple<glm::vec2, float>> inputs;
        for (int j = 0; j < steps; ++j)
            inputs.emplace_back(
                glm::vec2((static_cast<float>(i) + 0.5F) / steps, (static_cast<float>(j) + 0.5F) / steps),
                1.0F);
        for (const glm::vec2 p : printed(inputs)) {
            longest = std::max(longest, static_cast<double>(glm::length(p)));
            moved += glm::length(p) > 0.99999F ? 1 : 0;
        }
        for (const glm::vec2 p : polar(inputs)) {
            longest = std::max(longest, static_cast<double>(glm::length(p)));
            sum += static_cast<double>(glm::length(p));
        }
    }
    EXPECT_LE(longest, 1.000001);
    EXPECT_NEAR(sum / (steps * steps), 0.5, 1e-4);
    EXPECT_NEAR(moved / double{steps * steps}, 0.031, 0.003);  // what leaves the disc as printed
}

// With the size of the disc, and with the distance.
TEST_F(Sampling, CountsAreMonotonous) {
    const Function<int(float, float, int, int)> by_radius(lab, "gloam/sampling/count_by_radius.glsl",
                                                          "gloam_count_by_radius");
    const Function<int(float, float, int, int)> by_distance(lab, "gloam/sampling/count_by_distance.glsl",
                                                            "gloam_count_by_distance");
    int fewer = 0;
    for (int r = 0; r <= 64; ++r) {
        const int now = by_radius(static_cast<float>(r), 64.0F, 2, 12);
        EXPECT_GE(now, fewer);
        fewer = now;
    }
    int more = 65;
    for (float d = 0; d <= 120; d += 0.75F) {
        const int now = by_distance(d, 100.0F, 64, 2);
        EXPECT_LE(now, more);
        more = now;
    }
}

TEST_F(Sampling, ChainOfAnyImageSizeStaysInsideIt) {
    const std::string file = "gloam/sampling/depth_mip.glsl";
    const Function<glm::ivec2(glm::ivec2, glm::ivec2, int)> pixel(lab, file, "gloam_depth_mip_pixel");
    const Function<glm::ivec2(glm::ivec2, glm::ivec2, int)> source(lab, file, "gloam_depth_mip_source");
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(7, 5), glm::ivec2(8, 1), glm::ivec2(1920, 1081)}) {
        for (const int level : {0, 1, 2, 5}) {
            const glm::ivec2 last = pixel(size - 1, size, level);
            const glm::ivec2 from = source(last, size, level);
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(from, glm::ivec2(0))) &&
                        glm::all(glm::lessThan(from, size)))
                << size.x << "x" << size.y << " level " << level;
        }
    }
    // No half-texel drift: a level's pixel lies over the pixel that it came from.
    for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(13, 21), glm::ivec2(31, 17)}) {
        for (const int level : {1, 2, 5}) {
            EXPECT_EQ(source(at, glm::ivec2(2048), level) >> level, at) << level;
        }
    }
}

}  // namespace gloam::sampling_test
