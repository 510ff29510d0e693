// SPDX-License-Identifier: MIT
// Every method of glsl/gloam/methods on scenes whose result is known in closed form.
#include <regex>

#include "gathers.hpp"

namespace gloam::method_gathers_test {

// A file of the folder that no descriptor names is tried by nothing.
TEST(MethodFiles, EachHasADescriptor) {
    std::set<std::string> files;
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(GLOAM_GLSL_DIR) / "gloam/methods"))
        files.insert("gloam/methods/" + file.path().filename().string());
    std::set<std::string> described;
    for (const effect::MethodInfo& method : effect::methods()) described.insert(file_of(method));
    EXPECT_EQ(files, described);
}

// The members of a struct of some file of the methods: a method may have that of a relative.
std::vector<std::string> members_of(const std::string& structure) {
    const std::regex member(R"( +(?:float|u?int|bool) (\w+);.*)");
    std::vector<std::string> members;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(GLOAM_GLSL_DIR) / "gloam/methods")) {
        std::ifstream file(entry.path());
        std::string line;
        while (std::getline(file, line) && line != "struct " + structure + " {") {
        }
        for (std::smatch found; std::getline(file, line) && line != "};";)
            if (std::regex_match(line, found, member)) members.push_back(found[1]);
    }
    return members;
}

// A call sets the members by their position: the descriptor has their names, so that no two can be exchanged.
TEST(MethodFiles, EachStructHasTheMembersOfItsDescriptor) {
    for (const effect::MethodInfo& method : effect::methods()) {
        if (method.own_settings.empty()) continue;
        std::vector<std::string> described;
        for (const effect::MethodMember& one : method.members) described.push_back(one.name);
        const std::vector<std::string> declared = members_of(method.own_settings);
        EXPECT_FALSE(declared.empty()) << method.name;
        EXPECT_EQ(declared, described) << method.name;
    }
}

// One test for each method, so that its kernel is compiled once.
class Methods : public testing::TestWithParam<std::string> {
  protected:
    void a_groove_has_the_methods_own_value() const;
    void frames_add_up_to_one_of_all_their_samples() const;
    void a_sample_sees_the_pixels_of_its_point() const;
    void nothing_below_the_bias_blocks() const;
    void both_taps_of_a_pair_are_alike() const;
    void points_behind_the_eye_are_not_samples() const;
    void nothing_is_gathered_where_there_is_nothing() const;

    test::Gathers gathers;
    check::Function<Gather> gather = gathers[GetParam()];
    const effect::MethodInfo& info = effect::method_named(GetParam());

    // That as many samples count as were asked for; fewer, but some, where several fall into one pixel.
    void expect_taken(double counted, unsigned asked) const {
        if (!info.takes_fewer) {
            EXPECT_EQ(counted, asked);
        } else {
            EXPECT_GT(counted, 0.0);
            EXPECT_LE(counted, asked);
        }
    }

    // The mean over `batches` times 64 samples of one point, as that many frames would take them.
    double mean(const check::ImageSet& image, glm::vec3 position, const Camera& camera, float radius,
                const Method& method, unsigned batches = 64) const {
        std::vector<test::GatherInputs> inputs;
        for (unsigned b = 0; b < batches; ++b) {
            const Samples samples{
                .radius = radius, .bias = 1e-5F, .angle = 0.0F, .first = 64 * b, .count = 64};
            inputs.emplace_back(position, glm::vec3(0, 0, 1), camera, samples, method);
        }
        double sum = 0.0;
        double count = 0.0;
        for (const glm::vec2 part : gather(inputs, image)) {
            sum += static_cast<double>(part.x);
            count += static_cast<double>(part.y);
        }
        expect_taken(count, 64 * batches);
        return sum / count;
    }
};

constexpr double groove_sigma = 0.2;

// Results that depend on lengths (disc, sao, issao, aksoy_phaneuf), on the size of a pixel (sphere_proxy,
// mixture) or of a footprint (curvature) are not in closed form here.
const std::map<std::string, double> of_a_groove{{"hemisphere", 0.146447},
                                                {"gtao", 0.146447},
                                                {"sweep", 0.146447},
                                                {"bitmask", 0.146447},
                                                {"filion", 0.25},
                                                {"hbao", 0.25},
                                                {"hbao_study", 0.25},
                                                {"crytek", 0.625},
                                                {"volumetric", 0.5 + 1.0 / (4.0 * std::numbers::pi)},
                                                {"volumetric_two", 0.5 + 1.0 / (2.0 * std::numbers::pi)},
                                                {"volumetric_spiral", 0.5 + 1.0 / (4.0 * std::numbers::pi)},
                                                {"angle", 1.0 - 0.828708},
                                                {"alchemy", 0.793515 * groove_sigma},
                                                {"hsao", 0.25},
                                                {"poisson", 0.146447},
                                                {"ssdo", 0.146447},
                                                {"disc_proxy", 0.0},
                                                {"unreal", 0.5},
                                                {"depth_darkening", 0.170374 * groove_sigma}};

// A floor from whose middle line the right half rises by 45 degrees: at the line nothing depends on the
// falloff. Each method has its own value there, and the difference is the point.
void Methods::a_groove_has_the_methods_own_value() const {
    const Camera camera{glm::vec2(0.5F, -0.5F), glm::ivec2(257, 257), true};
    const double pixel = 4.0 / 257.0;
    const auto image = test::view_of(
        camera.size, [&](glm::ivec2 p) { return static_cast<float>(5.0 - pixel * std::max(p.x - 128, 0)); },
        [&](glm::ivec2 p) { return p.x > 128 ? glm::normalize(glm::vec3(-1, 0, 1)) : glm::vec3(0, 0, 1); });
    const std::map<std::string, float> epsilons{{"alchemy", 1e-3F}, {"unreal", 0.8F}};
    const std::set<std::string> full{"hbao", "hbao_study", "hsao", "unreal"};
    const std::set<std::string> rays{"poisson", "ssdo"};
    const auto epsilon = epsilons.find(GetParam());
    const Method method{.epsilon = epsilon == epsilons.end() ? 0.05F : epsilon->second,
                        .intensity = full.contains(GetParam()) ? 1.0F : static_cast<float>(groove_sigma),
                        .thickness = 1e3F,
                        // Steps finer than pixels see their steps: a ray is blocked by the first of them.
                        .steps = rays.contains(GetParam()) ? 4U : 16U,
                        .feature_thickness = 1e18F};
    const double measured = mean(image, glm::vec3(0, 0, -5), camera, 1.0F, method);
    RecordProperty("groove", std::to_string(measured));
    const auto expected = of_a_groove.find(GetParam());
    if (expected == of_a_groove.end()) {
        EXPECT_GT(measured, 0.01);
        EXPECT_LT(measured, 1.0);
    } else {
        // Methods that keep the highest of several taps see the pixels' steps rather than their mean.
        EXPECT_NEAR(measured, expected->second, 0.03);
    }
}

// TSSAO-4 and -5: frames that follow one another are as one frame of all their samples, no sample is taken
// twice and none is counted that was not taken.
void Methods::frames_add_up_to_one_of_all_their_samples() const {
    const Camera camera{glm::vec2(0.5F, -0.5F), glm::ivec2(129, 129), true};
    const auto image = test::view_of(
        camera.size,
        [](glm::ivec2 p) { return static_cast<float>(5.0 - 0.02 * std::max(p.x + p.y / 2 - 96, 0)); },
        [](glm::ivec2 p) { return p.x > 64 ? glm::normalize(glm::vec3(-1, 0, 1)) : glm::vec3(0, 0, 1); });
    const Method method{.intensity = 0.2F, .steps = 6};
    const auto at = [&](unsigned first, unsigned count) {
        const Samples samples{.radius = 1.0F, .bias = 1e-4F, .angle = 0.5F, .first = first, .count = count};
        return glm::dvec2(
            gather.with_images(image, {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), camera, samples, method}));
    };
    // A pattern that depends on how many it has, and means with weights: of them the counts alone add up.
    const std::set<std::string> otherwise{
        "sao",   "volumetric",     "volumetric_two", "volumetric_spiral", "tangent_sphere",
        "angle", "depth_darkening"};
    if (info.takes_fewer) return;  // which samples count depends on those of the same frame
    for (const unsigned count : {1U, 3U, 4U, 17U, 32U}) {
        glm::dvec2 sum(0);
        for (int frame = 0; frame < 7; ++frame) {
            const glm::dvec2 one = at(static_cast<unsigned>(sum.y), count);
            EXPECT_EQ(one.y, effect::samples_taken(info, count, method.steps)) << count;
            sum += one;
        }
        const glm::dvec2 all = at(0, static_cast<unsigned>(sum.y));
        EXPECT_EQ(all.y, sum.y) << count;
        if (otherwise.contains(GetParam())) continue;
        EXPECT_NEAR(sum.x, all.x, 1e-5 * sum.y) << count;
    }
}

// One sample sees the pixel under its point of the shared sequence, a pair that and the opposite one, and no
// other.
void Methods::a_sample_sees_the_pixels_of_its_point() const {
    const bool pairs = info.unit == effect::SampleUnit::pair;
    const bool halves = GetParam() == "aksoy_phaneuf_two" || GetParam() == "volumetric_two";
    if (info.points != "disc" || halves || !(pairs || info.unit == effect::SampleUnit::one)) return;
    const check::Function<glm::vec3(unsigned)> disc(gathers.lab(), "gloam/sampling/disc.glsl",
                                                    "gloam_disc_point");
    const Camera camera{glm::vec2(0.55F, -0.8F), glm::ivec2(29, 47), true};
    const glm::ivec2 middle = camera.size / 2;
    const glm::vec2 reach = 0.5F * glm::abs(camera.p00_p11) * glm::vec2(camera.size);
    for (unsigned n = 0; n < 60; ++n) {
        const glm::vec2 point = disc(n + 1U);
        const glm::vec2 within = glm::fract(0.5F + point * reach);
        const glm::ivec2 tap = middle + glm::ivec2(glm::floor(0.5F + point * reach));
        const glm::ivec2 opposite = middle + glm::ivec2(glm::floor(0.5F - point * reach));
        const bool certain = glm::all(glm::lessThan(glm::abs(within - 0.5F), glm::vec2(0.48F)));
        if (!certain || tap == middle || opposite == middle) continue;
        const auto sum = [&](const auto& rises) {
            const auto image =
                test::view_of(camera.size, [&](glm::ivec2 p) { return rises(p) ? 4.7F : 5.0F; });
            const unsigned count = pairs ? 2U : 1U;
            const Samples samples{
                .radius = 1.0F, .bias = 1e-3F, .angle = 0.0F, .first = count * n, .count = count};
            return gather.with_images(image,
                                      {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), camera, samples, Method{}});
        };
        const auto seen = [&](glm::ivec2 p) { return p == tap || (pairs && p == opposite); };
        const glm::vec2 bare = sum([](glm::ivec2) { return false; });
        const bool far = glm::length(point) > 0.45F;  // a tangent ball ends at half the radius
        EXPECT_TRUE(far || sum(seen) != bare) << n;
        EXPECT_EQ(sum([&](glm::ivec2 p) { return p != middle && !seen(p); }), bare) << n;
    }
}

// Stripes on a plane block nothing as long as they are no higher than the bias, and something when they are
// higher. Not for methods that see nothing of such stripes, and those that have no bias. Of points on both
// sides of the plane, a bias above the radius opens those behind it.
void Methods::nothing_below_the_bias_blocks() const {
    const std::set<std::string> others{"crytek",         "poisson",           "disc_proxy",
                                       "angle",          "curvature",         "volumetric",
                                       "volumetric_two", "volumetric_spiral", "tangent_sphere"};
    const Camera camera{glm::vec2(0.55F, -0.8F), glm::ivec2(29, 47), true};
    float bias = 2.0F;
    const auto sum = [&](float height) {
        const auto image =
            test::view_of(camera.size, [&](glm::ivec2 p) { return p.x % 4 == 2 ? 5.0F : 5.0F - height; });
        const Samples samples{.radius = 1.0F, .bias = bias, .angle = 0.7F, .first = 0, .count = 64};
        return gather.with_images(image,
                                  {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), camera, samples, Method{}});
    };
    if (GetParam() == "crytek") {
        EXPECT_EQ(sum(0.0F).x, 0.0F);
    }
    if (others.contains(GetParam())) return;
    bias = 0.0625F;
    EXPECT_EQ(sum(0.03F), sum(0.0F));
    EXPECT_EQ(sum(bias), sum(0.0F));
    EXPECT_NE(sum(0.15F), sum(0.0F));
}

// A view that is turned by half a turn about the point has the same result, whichever tap of a pair comes
// first, and an orthographic one from wherever the eye looks.
void Methods::both_taps_of_a_pair_are_alike() const {
    const bool of_two_radii = GetParam() == "aksoy_phaneuf_two";
    if (info.unit != effect::SampleUnit::pair || of_two_radii) return;
    const Camera camera{glm::vec2(0.55F, -0.8F), glm::ivec2(29, 47), true};
    const auto sum = [&](bool turned, float depth) {
        const auto image = test::view_of(camera.size, [&](glm::ivec2 p) {
            const glm::ivec2 at = turned ? camera.size - 1 - p : p;
            const float bump = 0.125F * static_cast<float>((at.x * 31 + at.y * 17) % 11);
            return at.x < 14 && at.y % 3 == 0 ? infinity : depth - bump * static_cast<float>(at.x != 14);
        });
        const Samples samples{.radius = 1.0F, .bias = 1e-3F, .angle = 0.0F, .first = 0, .count = 64};
        return gather.with_images(image,
                                  {glm::vec3(0, 0, -depth), glm::vec3(0, 0, 1), camera, samples, Method{}});
    };
    const glm::vec2 one = sum(false, 5.0F);
    EXPECT_NE(one.x, info.on_a_plane * one.y);
    for (const glm::vec2 other : {sum(true, 5.0F), sum(false, 32768.0F)}) {
        EXPECT_NEAR(one.x, other.x, 1e-5F * one.y);
        EXPECT_EQ(one.y, other.y);
    }
}

void Methods::points_behind_the_eye_are_not_samples() const {
    if (!info.points.starts_with("hemisphere")) return;
    const Camera camera{glm::vec2(0.55F, -0.8F), glm::ivec2(29, 47), true};
    const auto taken = [&](float depth) {
        const auto image = test::view_of(camera.size, [&](glm::ivec2) { return depth; });
        const Samples samples{.radius = 1.0F, .bias = 1e-3F, .angle = 0.0F, .first = 0, .count = 64};
        return gather
            .with_images(image, {glm::vec3(0, 0, -depth), glm::vec3(0, 0, 1), camera, samples, Method{}})
            .y;
    };
    EXPECT_EQ(taken(1.01F), 64.0F);
    EXPECT_LT(taken(0.3F), 64.0F);
    EXPECT_GT(taken(0.3F), 0.0F);
}

void Methods::nothing_is_gathered_where_there_is_nothing() const {
    const Camera camera{glm::vec2(1, -1), glm::ivec2(5, 3), false};
    for (const float depth : {infinity, 0.0F, nan}) {
        const auto image = test::view_of(camera.size, [&](glm::ivec2) { return depth; });
        const Samples samples{.radius = 0.5F, .bias = 0.0F, .angle = 0.3F, .first = 0, .count = 16};
        const auto at = [&](glm::vec3 position, glm::vec3 normal) {
            return gather.with_images(image, {position, normal, camera, samples, Method{}});
        };
        EXPECT_EQ(at(glm::vec3(0, 0, -depth), glm::vec3(0, 0, 1)), glm::vec2(0));
        EXPECT_EQ(at(glm::vec3(0, 0, -2), glm::vec3(0)), glm::vec2(0));
        EXPECT_EQ(at(glm::vec3(0, 0, -2), glm::vec3(nan)), glm::vec2(0));
        EXPECT_EQ(at(glm::vec3(0, 0, 2), glm::vec3(0, 0, 1)), glm::vec2(0));
        for (const auto& [radius, count] : {std::pair{0.0F, 16U}, {nan, 16U}, {0.5F, 0U}}) {
            if (count == 0 && info.unit != effect::SampleUnit::one) continue;  // at least one unit is taken
            const Samples none{.radius = radius, .bias = 0.0F, .angle = 0.3F, .first = 0, .count = count};
            const glm::vec2 sum =
                gather.with_images(image, {glm::vec3(0, 0, -2), glm::vec3(0, 0, 1), camera, none, Method{}});
            EXPECT_EQ(sum, glm::vec2(0)) << radius << ' ' << count;
        }
        const glm::vec2 alone = at(glm::vec3(0, 0, -2), glm::vec3(0, 0, 1));  // a surface before nothing
        expect_taken(double{alone.y}, effect::samples_taken(info, 16, Method{}.steps));
        EXPECT_GE(alone.x, 0.0F);
        EXPECT_LE(alone.x / alone.y, info.on_a_plane);
    }
}

TEST_P(Methods, HaveTheirResults) {
    a_groove_has_the_methods_own_value();
    frames_add_up_to_one_of_all_their_samples();
    a_sample_sees_the_pixels_of_its_point();
    nothing_below_the_bias_blocks();
    both_taps_of_a_pair_are_alike();
    points_behind_the_eye_are_not_samples();
    nothing_is_gathered_where_there_is_nothing();
}

// Those that no passes prepare: tests/effect/preparation_test.cpp has the others, with the same scenes.
INSTANTIATE_TEST_SUITE_P(All, Methods,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             return method.prepare == nullptr;
                         })),
                         test::parameter_name);

}  // namespace gloam::method_gathers_test
