// SPDX-License-Identifier: MIT
// What the comments of glsl/gloam promise of every device that keeps Vulkan's rules, looked for in everything
// that the rules permit: no device of any kind is needed, and none could show it.
#include "check/explain.hpp"
#include "check/interpretation.hpp"
#include "check/interpreted_kernel.hpp"
#include "check/run.hpp"
#include "check/signature.hpp"
#include "numeric/numbers.hpp"
#include "support/lab.hpp"

namespace gloam::check::permitted_test {

using numeric::Bounds;

// A shader function, whose permitted outputs can be asked for.
template <class Signature>
class Rules {
  public:
    Rules(const std::string& file, const std::string& function)
        : kernel_(test::make_lab({}, shader::variant("strict"))
                      .kernel(file, function, check::SignatureOf<Signature>::describe())),
          modules_{std::make_shared<const check::KernelModule>(kernel_.module())},
          decoded_(modules_, images_),
          outputs_(check::SignatureOf<Signature>::describe().output_scalars()),
          interpretation_(decoded_, outputs_, outputs_.size(), false) {}

    // Bounds of every output word.
    template <class... Values>
    std::vector<Bounds> operator()(const Values&... values) {
        std::vector<check::Word> words;
        (check::append_words(values, words), ...);
        return check::hull_of(interpretation_.all_permitted({.index = 0, .words = words}));
    }

  private:
    check::KernelCore kernel_;
    check::KernelModules modules_;
    check::ImageSet images_;
    check::Decoded decoded_;
    std::vector<shader::Scalar> outputs_;
    check::Interpretation interpretation_;
};

void expect_within(const Bounds& bounds, double low, double high) {
    EXPECT_GE(bounds.low, low);
    EXPECT_LE(bounds.high, high);
    EXPECT_FALSE(bounds.nan);
}

struct History {
    float occlusion;
    float weight;
    unsigned index;
    float depth;
};

constexpr float least = 0x1p-126F;
constexpr float below = -0x1p-149F;  // the negative subnormal nearest to 0

TEST(FlushedSubnormals, AHistoryBelowZeroIsReadAsZero) {
    Rules<glm::vec2(float, float, float, float, float)> blend("gloam/temporal/blend.glsl", "gloam_blend");
    const auto blended = [&](float history, float k) { return blend(history, 8.0F, 1.0F, k, 500.0F)[0]; };
    expect_within(blended(below, 0.0F), 0.0, 0.0);
    expect_within(blended(below, infinity), 0.0, 0.0);
    expect_within(blended(0.5F, below), 0.5, 0.5);
    Rules<History(History)> sanitize("gloam/temporal/history.glsl", "gloam_history_sanitize");
    expect_within(sanitize(History{below, 8.0F, 3U, 1.0F})[0], 0.0, 0.0);
}

TEST(FlushedSubnormals, TheSupportOfAFilterWithATinyThresholdIsNone) {
    Rules<float(float, float)> shrink("gloam/filter/weights.glsl", "gloam_shrink");
    expect_within(shrink(least, std::nextafter(least, 1.0F))[0], 0.0, 0.0);
    // Just above the threshold the difference is still normal.
    expect_within(shrink(std::nextafter(1.0000001e-30F, 0.0F), 1.0000001e-30F)[0], 1e-8, 2e-7);
}

TEST(FlushedSubnormals, CoordinatesOfAPointAtTheEyeAreNotMadeUp) {
    Rules<bool(glm::vec4, check::Out<glm::vec2>)> uv("gloam/geometry/reprojection.glsl",
                                                     "gloam_uv_from_clip");
    for (const float w : {least, 1e-31F}) expect_within(uv(glm::vec4(w))[0], 0.0, 0.0);
    expect_within(uv(glm::vec4(1.1e-30F))[1], 0.999999, 1.0);
}

TEST(FlushedSubnormals, CreaseShadingOfTouchingPointsIsFinite) {
    Rules<float(glm::vec3, glm::vec3, float)> contribution("gloam/occlusion/disc_taps.glsl",
                                                           "gloam_contribution_fox_compton");
    expect_within(contribution(glm::vec3(least), glm::vec3(0.0F, -0.8F, -0.6F), 0.01F)[0], -1e-6, 1e-6);
}

// The largest error that the rules permit at evenly spaced inputs.
template <class Rounded, class Exact>
double largest_error(Rounded&& function, Exact&& exact, double low, double high) {
    constexpr int inputs = 4000;
    double worst = 0.0;
    for (int i = 0; i <= inputs; ++i) {
        const auto x = static_cast<float>(low + (high - low) * i / inputs);
        const Bounds bounds = function(x);
        EXPECT_FALSE(bounds.nan) << x;
        const double want = exact(static_cast<double>(x));
        worst = std::max({worst, want - bounds.low, bounds.high - want});
    }
    return worst;
}

// A bound that no device could miss would show nothing: the rounding alone is about as large as `limit`.
void expect_close_below(double error, double limit) {
    EXPECT_LT(error, limit);
    EXPECT_GT(error, limit / 8.0);
}

constexpr double turn = 6.28318530717958647692;

TEST(ErrorBound, SineAndCosine) {
    Rules<glm::vec2(float, int)> octant("gloam/numeric/sincos.glsl", "gloam_sincos_octant");
    Rules<glm::vec2(float)> turns("gloam/numeric/sincos.glsl", "gloam_sincos_turns");
    const auto cosine = [](double x) { return std::cos(x); };
    const auto sine = [](double x) { return std::sin(x); };
    const auto part = [](auto& rules, std::size_t i) { return [&rules, i](float x) { return rules(x)[i]; }; };
    const auto near_zero = [&](std::size_t i) { return [&octant, i](float x) { return octant(x, 0)[i]; }; };
    expect_close_below(largest_error(near_zero(0), cosine, 0, turn / 8), 4e-7);
    expect_close_below(largest_error(near_zero(1), sine, 0, turn / 8), 4e-7);
    expect_close_below(
        largest_error(part(turns, 0), [](double t) { return std::cos(turn * t); }, 0, 1), 5e-7);
    expect_close_below(
        largest_error(part(turns, 1), [](double t) { return std::sin(turn * t); }, 0, 1), 5e-7);
}

TEST(ErrorBound, InverseFunctions) {
    constexpr const char* file = "gloam/numeric/inverse_trigonometry.glsl";
    const auto error = [](const char* function, auto exact, double low, double high) {
        Rules<float(float)> rules(file, function);
        return largest_error([&](float x) { return rules(x)[0]; }, exact, low, high);
    };
    expect_close_below(error("gloam_asin_half", [](double x) { return std::asin(x); }, 0, 0.5), 1.4e-7);
    expect_close_below(error("gloam_acos", [](double x) { return std::acos(x); }, -1, 1), 1e-6);
    expect_close_below(error("gloam_atan", [](double x) { return std::atan(x); }, -4, 4), 1e-6);
    Rules<float(float, float)> atan2(file, "gloam_atan2");
    const auto half_turn = [&](float x) { return atan2(x, -1.0F)[0]; };
    expect_close_below(
        largest_error(half_turn, [](double y) { return std::atan2(y, -1.0); }, 0.001, 1), 1e-6);
}

// Over two binades.
TEST(ErrorBound, SquareRoot) {
    Rules<float(float)> root("gloam/numeric/arithmetic.glsl", "gloam_sqrt");
    const auto relative = [&](float x) {
        const Bounds bounds = root(x)[0];
        const double ulp = numeric::ulp_size(std::sqrt(static_cast<double>(x)));
        return Bounds{bounds.low / ulp, bounds.high / ulp, bounds.nan};
    };
    const auto exact = [](double x) { return std::sqrt(x) / numeric::ulp_size(std::sqrt(x)); };
    expect_close_below(largest_error(relative, exact, 1.0, 3.999), 7.0);
}

// One input, operation by operation.

Explanation explained(const char* file, const char* function, const std::vector<float>& values) {
    const Lab lab = test::make_lab(FIXTURES, shader::variant("strict"));
    KernelSource source = lab.source(file, function, SignatureOf<float(float, float)>::describe());
    source.images.clear();  // which the function does not read
    std::vector<Word> words;
    for (const float value : values) words.push_back(to_word(value));
    return explain(lab.compile_options(), source, words);
}

TEST(Explain, TellsWhereTheErrorEnters) {
    const Explanation all = explained("own.glsl", "own_root", {1.0F, 1e-4F});
    std::vector<std::string> operations;
    for (const ExplainedStep& step : all.steps) operations.push_back(step.operation);
    EXPECT_THAT(operations, ElementsAre("OpFMul", "OpFSub", "GLSL.std.450 Sqrt", "OpFSub"));
    EXPECT_THAT(all.steps[0].file, HasSubstr("own.glsl"));
    EXPECT_EQ(all.steps[0].function, "own_root");
    EXPECT_EQ(all.steps[0].line, 11U);
    EXPECT_EQ(all.steps[3].line, 12U);
    ASSERT_EQ(all.worst, 3U) << "the difference of what is nearly equal";
    EXPECT_GT(all.steps[3].ulps, 100.0);
    EXPECT_EQ(all.steps[3].local, 0.0) << "which is exact in itself";
    EXPECT_NEAR(all.steps[3].inherited(), all.steps[3].error, 1e-30);
}

TEST(Explain, KeepsTheThreeValuesApart) {
    const ExplainedStep step = explained("rules.glsl", "quotient", {1.0F, 3.0F}).steps.back();
    EXPECT_EQ(step.value, 1.0F / 3.0F);
    EXPECT_EQ(step.exact, 1.0 / 3.0);
    EXPECT_EQ(step.local, static_cast<double>(1.0F / 3.0F) - 1.0 / 3.0);
    EXPECT_LT(step.permitted.low, step.exact);
    EXPECT_GT(step.permitted.high, step.exact);
    EXPECT_LT(step.permitted.high - step.permitted.low, 1e-6);
}

TEST(Explain, SaysWhatItExpected) {
    expect_error<std::invalid_argument>([] { (void)explained("rules.glsl", "quotient", {1.0F}); },
                                        {"takes 2 values, got 1"});
}

TEST(Scalars, TypesAreThoseOfGlsl) {
    EXPECT_EQ(shader::to_glsl(type_of<glm::mat4x3>()), "mat4x3");
    EXPECT_EQ(shader::to_glsl(type_of<glm::uvec2>()), "uvec2");
    EXPECT_EQ(type_of<double>(), type_of<float>())
        << "references calculate in double what the shader has in float";
}

}  // namespace gloam::check::permitted_test
