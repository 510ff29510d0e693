// SPDX-License-Identifier: MIT
#include "judge/function.hpp"
#include "support/lab.hpp"

namespace gloam::subject::kernel_test {

using namespace judge;

// The C++ side of the fixture's struct: matched by layout, no description needed.
struct Texel {
    float occlusion;
    glm::vec2 moments;
    unsigned index;
    bool valid;
};

class KernelTest : public testing::Test {
  protected:
    Lab lab = test::make_lab(FIXTURES);

    template <class Type>
    Function<Type> kernel(const std::string& function, const std::string& file = "types.glsl") {
        return {lab, file, function};
    }

    // The message of the exception that making a kernel throws.
    template <class Type>
    std::string failure(const std::string& function, const std::string& file = "types.glsl") {
        try {
            (void)kernel<Type>(function, file);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "no exception";
    }
};

TEST_F(KernelTest, ValuesOfEveryTypeGoInAndOut) {
    EXPECT_EQ(
        kernel<float(glm::vec2, glm::vec3, float)>("add_scaled")(glm::vec2(1, 2), glm::vec3(3, 4, 5), 2.0F),
        108642.0F);
    EXPECT_EQ(kernel<float()>("answer")(), 42.0F);
    EXPECT_EQ(kernel<int(int)>("negate_int")(7), -7);
    EXPECT_EQ(kernel<unsigned(unsigned, unsigned)>("shift_uint")(3U, 31U), 0x80000000U);
    EXPECT_EQ(kernel<glm::ivec2(glm::ivec2)>("swap_ints")(glm::ivec2(-1, 2)), glm::ivec2(2, -1));
    EXPECT_EQ(kernel<glm::bvec3(glm::bvec3)>("flip_bools")(glm::bvec3(true, false, true)),
              glm::bvec3(false, true, false));
    EXPECT_EQ(kernel<glm::uvec4(glm::uvec4)>("reverse_uints")(glm::uvec4(1, 2, 3, 4)),
              glm::uvec4(4, 3, 2, 1));
    const auto both = kernel<bool(bool, bool)>("both");
    EXPECT_TRUE(both(true, true));
    EXPECT_FALSE(both(true, false));
    // Matrices keep columns and rows.
    const glm::mat4 m(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
    EXPECT_EQ(kernel<glm::vec4(glm::mat4, glm::vec4)>("transform")(m, glm::vec4(1, 10, 100, 1000)),
              m * glm::vec4(1, 10, 100, 1000));
    EXPECT_EQ(kernel<glm::mat2x3(glm::vec3, glm::vec2)>("outer")(glm::vec3(1, 2, 3), glm::vec2(10, 100)),
              glm::mat2x3(10, 20, 30, 100, 200, 300));
    EXPECT_EQ(kernel<glm::mat3x2(glm::mat2x3)>("transpose_matrix")(glm::mat2x3(1, 2, 3, 4, 5, 6)),
              glm::mat3x2(1, 4, 2, 5, 3, 6));
    const Texel texel = kernel<Texel(Texel, unsigned)>("advance")(Texel{0.5F, {1, 2}, 7U, false}, 3U);
    EXPECT_EQ(texel.occlusion, 0.5F);
    EXPECT_EQ(texel.moments, glm::vec2(2, 1));
    EXPECT_EQ(texel.index, 10U);
    EXPECT_TRUE(texel.valid);
}

TEST_F(KernelTest, OutAndInoutParametersAreReturnedBehindTheResult) {
    const auto split = kernel<bool(float, Out<float>, float&)>("split");
    const auto [positive, whole, sum] = split(2.75F, 10.0F);
    EXPECT_TRUE(positive);
    EXPECT_EQ(whole, 2.0F);
    EXPECT_EQ(sum, 10.75F);
    EXPECT_EQ(kernel<void(float, Out<glm::vec2>)>("nothing_returned")(3.0F), glm::vec2(6, 3));
}

TEST_F(KernelTest, OverloadsAreToldApartBySignature) {
    EXPECT_EQ(kernel<float(float)>("overloaded")(3.0F), 3.0F);
    EXPECT_EQ(kernel<float(glm::vec2)>("overloaded")(glm::vec2(3, 4)), 7.0F);
}

TEST_F(KernelTest, ManyInputsInOneDispatchKeepTheirOrder) {
    const auto shift = kernel<unsigned(unsigned, unsigned)>("shift_uint");
    std::vector<std::tuple<unsigned, unsigned>> inputs;
    for (unsigned i = 0; i < 1'000'003U; ++i) inputs.emplace_back(i, 1U);
    const std::vector<unsigned> outputs = shift(inputs);
    ASSERT_EQ(outputs.size(), inputs.size());
    for (unsigned i = 0; i < outputs.size(); ++i) ASSERT_EQ(outputs[i], 2U * i);
    EXPECT_TRUE(shift(std::span<const std::tuple<unsigned, unsigned>>{}).empty());
}

TEST_F(KernelTest, MessagesSayWhatIsWrong) {
    EXPECT_THAT(failure<float(glm::vec2, float)>("add_scaled"),
                AllOf(HasSubstr("float add_scaled(vec2, float)"),
                      HasSubstr("float add_scaled(vec2 a, vec3 b, float s)")));
    EXPECT_THAT(failure<int(unsigned)>("negate_int"), HasSubstr("signature"));
    EXPECT_THAT(failure<bool(float, float&, float&)>("split"),
                AllOf(HasSubstr("out float"), HasSubstr("inout float")));
    EXPECT_THAT(failure<glm::vec4(glm::mat3, glm::vec4)>("transform"), HasSubstr("mat3"));
    struct Other {
        float occlusion;
        glm::vec3 moments;
        unsigned index;
        bool valid;
    };
    EXPECT_THAT(failure<Other(Other, unsigned)>("advance"), HasSubstr("vec3"));
    EXPECT_THAT(failure<float(float)>("no_such"),
                AllOf(HasSubstr("no function no_such"), HasSubstr("negate_int")));
    EXPECT_THAT(failure<float(float)>("f", "nowhere.glsl"),
                AllOf(testing::StartsWith("cannot find include"), HasSubstr(FIXTURES "/nowhere.glsl")));
    EXPECT_THAT(failure<float(float)>("uses_broken", "includes_broken.glsl"),
                AllOf(HasSubstr("broken.glsl:5"), HasSubstr("undeclared")));
}

TEST_F(KernelTest, SpecialValuesSurviveTheTrip) {
    const auto same = kernel<float(float)>("overloaded");
    EXPECT_TRUE(std::isinf(same(infinity)));
    EXPECT_TRUE(std::isnan(same(nan)));
    EXPECT_TRUE(std::signbit(same(-0.0F)));
}

class KernelImageTest : public testing::Test {
  protected:
    Lab lab = test::make_lab(FIXTURES);
    Function<float(glm::ivec2)> plus{lab, "images.glsl", "plus"};

    static ImageSet images(glm::ivec2 size, Border border) {
        return {{"fetch_depth", make_image<float>(
                                    size, [](glm::ivec2 p) { return float(p.x + 10 * p.y); }, border)},
                {"fetch_normal",
                 make_image<glm::vec3>(size, [](glm::ivec2 p) { return glm::vec3(9, 9, p.x + 1); }, border)}};
    }
};

TEST_F(KernelImageTest, ServesPrototypesFromImagesOfAnySize) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 3), glm::ivec2(7, 2), glm::ivec2(1, 5)}) {
        const ImageSet set = images(size, Border::clamp);
        std::vector<std::tuple<glm::ivec2>> inputs;
        for (int i = 0; i < size.x * size.y; ++i) inputs.emplace_back(glm::ivec2(i % size.x, i / size.x));
        const std::vector<float> sums = plus(inputs, set);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const glm::ivec2 p = std::get<0>(inputs[i]);
            float want = 0.0F;
            for (const glm::ivec2 offset :
                 {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
                want += set.at("fetch_depth").at<float>(p + offset);
            }
            EXPECT_EQ(sums[i], want * float(p.x + 1));
        }
    }
}

TEST_F(KernelImageTest, ReadOutsideIsAFaultThatNamesImageAndPixel) {
    const ImageSet set = images({3, 3}, Border::fault);
    EXPECT_NO_THROW((void)plus.with_images(set, {glm::ivec2(1, 1)}));
    expect_error<std::runtime_error>([&] { (void)plus.with_images(set, {glm::ivec2(0, 1)}); },
                                     {"fetch_depth: pixel (-1, 1) is outside the 3 x 3 image"});
}

TEST_F(KernelImageTest, MissingOrWrongImageIsNamed) {
    ImageSet set = images({3, 3}, Border::clamp);
    set.erase("fetch_normal");
    expect_error<std::invalid_argument>([&] { (void)plus.with_images(set, {glm::ivec2(1, 1)}); },
                                        {"fetch_normal; given: fetch_depth"});
    set["fetch_normal"] = make_image<float>({3, 3}, [](glm::ivec2) { return 1.0F; });
    expect_error<std::invalid_argument>([&] { (void)plus.with_images(set, {glm::ivec2(1, 1)}); }, {"vec3"});
    EXPECT_THROW((void)make_image<float>({0, 3}, [](glm::ivec2) { return 1.0F; }), std::invalid_argument);
}

// What else a function can be asked.

TEST_F(KernelTest, APropertyThatFailsShrinksInsideItsDomain) {
    const Function<float(float)> reciprocal = kernel<float(float)>("reciprocal", "rules.glsl");
    const PropertyResult positive =
        reciprocal.property({uniform(1, 100)}, [](float, float y) { return y > 0.0F; });
    EXPECT_TRUE(positive) << positive;
    EXPECT_EQ(positive.inputs, 65'536U);
    const PropertyResult large = reciprocal.property(
        {uniform(3, 100)}, [](float x, float y) { return x < 10.0F || y > 0.1F; }, {.inputs = 512});
    ASSERT_FALSE(large);
    EXPECT_EQ(large.words, std::vector<Word>{to_word(16.0F)}) << "the simplest float at or above 10";
    std::ostringstream text;
    text << large;
    EXPECT_THAT(text.str(), AllOf(HasSubstr("the property does not hold for float 16"), HasSubstr("0.0625")));
}

TEST_F(KernelTest, APropertyTakesOutputsApartOrTogether) {
    const auto split = kernel<bool(float, Out<float>, float&)>("split");
    const Domain domain{uniform(0, 100), constant(0.0F)};
    const auto apart = [](float x, float, bool, float whole, float) { return whole == std::floor(x); };
    const auto together = [](float x, float, const std::tuple<bool, float, float>& outputs) {
        return std::get<1>(outputs) == std::floor(x);
    };
    EXPECT_TRUE(split.property(domain, apart).passed());
    EXPECT_TRUE(split.property(domain, together).passed());
}

}  // namespace gloam::subject::kernel_test
