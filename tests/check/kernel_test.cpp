// SPDX-License-Identifier: MIT
#include "check/kernel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/lab.hpp"

namespace gloam::check {
namespace kernel_test {

using testing::AllOf;
using testing::HasSubstr;

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

    template <class Function>
    Kernel<Function> kernel(const std::string& function, const std::string& file = "types.glsl") {
        return {lab, file, function};
    }

    // The message of the exception that making a kernel throws.
    template <class Function>
    std::string failure(const std::string& function, const std::string& file = "types.glsl") {
        try {
            (void)kernel<Function>(function, file);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "no exception";
    }
};

TEST_F(KernelTest, ScalarsAndVectors) {
    EXPECT_EQ(
        kernel<float(glm::vec2, glm::vec3, float)>("add_scaled")(glm::vec2(1, 2), glm::vec3(3, 4, 5), 2.0F),
        108642.0F);
    EXPECT_EQ(kernel<int(int)>("negate_int")(7), -7);
    EXPECT_EQ(kernel<unsigned(unsigned, unsigned)>("shift_uint")(3U, 31U), 0x80000000U);
    EXPECT_EQ(kernel<glm::ivec2(glm::ivec2)>("swap_ints")(glm::ivec2(-1, 2)), glm::ivec2(2, -1));
    EXPECT_EQ(kernel<glm::bvec3(glm::bvec3)>("flip_bools")(glm::bvec3(true, false, true)),
              glm::bvec3(false, true, false));
    EXPECT_EQ(kernel<glm::uvec4(glm::uvec4)>("reverse_uints")(glm::uvec4(1, 2, 3, 4)),
              glm::uvec4(4, 3, 2, 1));
}

TEST_F(KernelTest, Bools) {
    const auto both = kernel<bool(bool, bool)>("both");
    EXPECT_TRUE(both(true, true));
    EXPECT_FALSE(both(true, false));
}

TEST_F(KernelTest, MatricesKeepColumnsAndRows) {
    const glm::mat4 m(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
    EXPECT_EQ(kernel<glm::vec4(glm::mat4, glm::vec4)>("transform")(m, glm::vec4(1, 10, 100, 1000)),
              m * glm::vec4(1, 10, 100, 1000));
    EXPECT_EQ(kernel<glm::mat2x3(glm::vec3, glm::vec2)>("outer")(glm::vec3(1, 2, 3), glm::vec2(10, 100)),
              glm::mat2x3(10, 20, 30, 100, 200, 300));
    EXPECT_EQ(kernel<glm::mat3x2(glm::mat2x3)>("transpose_matrix")(glm::mat2x3(1, 2, 3, 4, 5, 6)),
              glm::mat3x2(1, 4, 2, 5, 3, 6));
}

TEST_F(KernelTest, OutAndInoutParametersAreReturnedBehindTheResult) {
    const auto split = kernel<bool(float, Out<float>, float&)>("split");
    const auto [positive, whole, sum] = split(2.75F, 10.0F);
    EXPECT_TRUE(positive);
    EXPECT_EQ(whole, 2.0F);
    EXPECT_EQ(sum, 10.75F);
    EXPECT_EQ(kernel<void(float, Out<glm::vec2>)>("nothing_returned")(3.0F), glm::vec2(6, 3));
}

TEST_F(KernelTest, NoParameters) {
    EXPECT_EQ(kernel<float()>("answer")(), 42.0F);
}

TEST_F(KernelTest, StructsGoInAndOut) {
    const Texel texel = kernel<Texel(Texel, unsigned)>("advance")(Texel{0.5F, {1, 2}, 7U, false}, 3U);
    EXPECT_EQ(texel.occlusion, 0.5F);
    EXPECT_EQ(texel.moments, glm::vec2(2, 1));
    EXPECT_EQ(texel.index, 10U);
    EXPECT_TRUE(texel.valid);
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
}

TEST_F(KernelTest, NoInputsGiveNoOutputs) {
    const auto negate = kernel<int(int)>("negate_int");
    EXPECT_TRUE(negate(std::span<const std::tuple<int>>{}).empty());
}

TEST_F(KernelTest, MismatchedSignaturePrintsBoth) {
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
}

TEST_F(KernelTest, UnknownFunctionListsThoseThereAre) {
    EXPECT_THAT(failure<float(float)>("no_such"),
                AllOf(HasSubstr("no function no_such"), HasSubstr("negate_int")));
}

TEST_F(KernelTest, UnknownFileIsNamed) {
    EXPECT_THAT(failure<float(float)>("f", "nowhere.glsl"), HasSubstr("nowhere.glsl"));
}

TEST_F(KernelTest, CompileErrorNamesTheFileAndLineOfTheInclude) {
    EXPECT_THAT(failure<float(float)>("uses_broken", "includes_broken.glsl"),
                AllOf(HasSubstr("broken.glsl:5"), HasSubstr("undeclared")));
}

TEST_F(KernelTest, SpecialValuesSurviveTheTrip) {
    const auto same = kernel<float(float)>("overloaded");
    EXPECT_TRUE(std::isinf(same(std::numeric_limits<float>::infinity())));
    EXPECT_TRUE(std::isnan(same(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_TRUE(std::signbit(same(-0.0F)));
}

}  // namespace kernel_test
}  // namespace gloam::check
