// SPDX-License-Identifier: MIT
// What the comments of glsl/gloam promise of every device that keeps Vulkan's rules, looked for in everything
// that the rules permit: no device of any kind is needed, and none could show it.
#include "judge/interpretation.hpp"
#include "numeric/numbers.hpp"
#include "subject/signature.hpp"
#include "support/lab.hpp"

namespace gloam::judge::permitted_test {

using namespace subject;

using numeric::Bounds;

// A shader function, whose permitted outputs can be asked for.
template <class Signature>
class Rules {
  public:
    Rules(const std::string& file, const std::string& function)
        : decoded_(decode({std::make_shared<const KernelModule>(
                              test::make_lab(FIXTURES, module::variant("strict"))
                                  .kernel(file, function, SignatureOf<Signature>::describe())
                                  .module())},
                          {})),
          interpretation_(decoded_, SignatureOf<Signature>::describe(), false) {}

    // Bounds of every output word.
    template <class... Values>
    std::vector<Bounds> operator()(const Values&... values) {
        std::vector<Word> words;
        (append_words(values, words), ...);
        return hull_of(interpretation_.all_permitted({.index = 0, .words = words}));
    }

  private:
    Decoded decoded_;
    Interpretation interpretation_;
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
    Rules<bool(glm::vec4, Out<glm::vec2>)> uv("gloam/geometry/reprojection.glsl", "gloam_uv_from_clip");
    for (const float w : {least, 1e-31F}) expect_within(uv(glm::vec4(w))[0], 0.0, 0.0);
    expect_within(uv(glm::vec4(1.1e-30F))[1], 0.999999, 1.0);
}

TEST(FlushedSubnormals, CreaseShadingOfTouchingPointsIsFinite) {
    Rules<float(glm::vec3, glm::vec3, float)> contribution("gloam/occlusion/disc_taps.glsl",
                                                           "gloam_contribution_fox_compton");
    expect_within(contribution(glm::vec3(least), glm::vec3(0.0F, -0.8F, -0.6F), 0.01F)[0], -1e-6, 1e-6);
}

// A fraction beside a whole number is near 0 or near 1, and nothing between.
TEST(NearWholeNumbers, OnlyWhatSomeNumberLeadsToIsPermitted) {
    const struct {
        const char* function;
        float x;
        double low, high;
    } rows[]{{"red", 0.0F, 1.0, 1.0},
             {"red", 1.0F, 1.0, 1.0},
             {"eased", 0.7F, -1e-6, 1.000001},
             {"leaning", 0.7F, 0.0, 1.000001},
             {"value_noise", 0.7F, 0.749999, 0.750001}};
    for (const auto& [function, x, low, high] : rows) {
        SCOPED_TRACE(function);
        expect_within(Rules<float(float)>("rules.glsl", function)(x)[0], low, high);
    }
}

// The error that the rules permit at drawn inputs. A bound that no device could miss would show nothing: the
// rounding alone is about as large as the limit.
template <class Signature, class Reference>
void expect_guaranteed(const char* file, const char* function, Reference reference, const Domain& domain,
                       const Budget& limit) {
    const Answer answer = Function<Signature>(test::make_lab({}, module::variant("strict")), file, function)
                              .compare(reference, domain, limit, {.inputs = 8192});
    EXPECT_TRUE(answer.passed()) << answer;
    EXPECT_LT(answer.guarantee.fraction, 1.0) << function;
    EXPECT_GT(answer.guarantee.fraction, 1.0 / 8.0) << function;
}

constexpr double turn = 6.28318530717958647692;

TEST(ErrorBound, SineAndCosine) {
    constexpr const char* file = "gloam/numeric/sincos.glsl";
    const auto both = [](double x) { return glm::dvec2(std::cos(x), std::sin(x)); };
    expect_guaranteed<glm::vec2(float, int)>(file, "gloam_sincos_octant",
                                             [=](double x, int) { return both(x); },
                                             {uniform(0, turn / 8), integers(0, 0)}, {.absolute = 4e-7});
    // Beside a half, floor(t + 0.5) is 0 or 1: bounds that hold both say nothing.
    for (const Values& turns : {uniform(0, 0.49), uniform(0.51, 1)})
        expect_guaranteed<glm::vec2(float)>(file, "gloam_sincos_turns",
                                            [=](double t) { return both(turn * t); }, {turns},
                                            {.absolute = 5e-7});
}

TEST(ErrorBound, InverseFunctionsAndRoots) {
    constexpr const char* file = "gloam/numeric/inverse_trigonometry.glsl";
    const auto expect = [](const char* in, const char* function, double (*exact)(double),
                           const Values& values, const Budget& limit) {
        expect_guaranteed<float(float)>(in, function, exact, {values}, limit);
    };
    expect(file, "gloam_asin_half", std::asin, uniform(0, 0.5), {.absolute = 1.4e-7});
    expect(file, "gloam_acos", std::acos, uniform(-1, 1), {.absolute = 1e-6});
    expect(file, "gloam_atan", std::atan, uniform(-4, 4), {.absolute = 1e-6});
    expect("gloam/numeric/arithmetic.glsl", "gloam_sqrt", std::sqrt, uniform(1, 3.999), {.ulp = 7});
    expect_guaranteed<float(float, float)>(file, "gloam_atan2",
                                           [](double y, double x) { return std::atan2(y, x); },
                                           {uniform(0.001, 1), constant(-1.0F)}, {.absolute = 1e-6});
}

}  // namespace gloam::judge::permitted_test
