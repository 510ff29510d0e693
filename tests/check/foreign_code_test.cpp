// SPDX-License-Identifier: MIT
// Functions of a user's files, with any other content: they run unchanged, or a message states why not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check/kernel.hpp"
#include "support/lab.hpp"

namespace gloam::check {
namespace foreign_code_test {

using testing::AllOf;
using testing::HasSubstr;

class ForeignCode : public testing::Test {
  protected:
    template <class Function>
    [[nodiscard]] Kernel<Function> kernel(const std::string& function,
                                          const std::string& file = "names.glsl") {
        return {lab_, file, function};
    }

    template <class Function>
    void expect_refused(const std::string& function, const std::string& named,
                        const std::string& file = "bindings.glsl") {
        EXPECT_THAT([&] { (void)kernel<Function>(function, file); },
                    testing::ThrowsMessage<std::invalid_argument>(
                        AllOf(HasSubstr(function), HasSubstr(named), HasSubstr("bindings of its own"))))
            << function;
    }

  private:
    Lab lab_ = test::make_lab(FIXTURES);
};

TEST_F(ForeignCode, BindingsOfTheirOwnAreNamed) {
    expect_refused<float(glm::vec2)>("reads_texture", "image or sampler \"texture_at_0\"");
    expect_refused<float(glm::vec2)>("reads_other_texture", "texture_at_7");
    expect_refused<float(float)>("reads_uniform", "uniform buffer \"Settings\"");
    expect_refused<float(int)>("reads_buffer", "storage buffer \"Values\"");
    expect_refused<float(int)>("reads_array", "\"pair\"");
    expect_refused<float(int)>("reads_length", "Values");
    expect_refused<float(int, float)>("writes_buffer", "Values");
    expect_refused<float(glm::ivec2)>("reads_image", "picture");
    expect_refused<float(float)>("calls", "Settings");
}

TEST_F(ForeignCode, BindingsThatTheFunctionDoesNotUseDoNotMatter) {
    EXPECT_EQ((kernel<float(float)>("uses_none", "bindings.glsl")(3.0F)), 6.0F);
}

TEST_F(ForeignCode, PushConstantsOfTheirOwnAreAnError) {
    EXPECT_THROW((void)kernel<float(float)>("reads_pushed", "push.glsl"), std::exception);
}

TEST_F(ForeignCode, NoNameCollidesWithOurs) {
    EXPECT_EQ(kernel<float(float)>("argument0")(1.0F), 2.0F);
    EXPECT_EQ(kernel<float(float)>("output_at")(1.0F), 3.0F);
    EXPECT_EQ(kernel<float(float)>("kernel_index")(1.0F), 4.0F);
    EXPECT_EQ(kernel<unsigned()>("kernel_input")(), 4U);
    EXPECT_EQ(kernel<float(float)>("kernel_inputs")(1.0F), 5.0F);
    EXPECT_EQ(kernel<float(float)>("result")(1.0F), 6.0F);
    struct Size {
        float x;
    };
    EXPECT_EQ(kernel<Size(Size)>("value")(Size{1.0F}).x, 7.0F);
}

TEST_F(ForeignCode, AMacroBehindAFunctionDoesNotReplaceIt) {
    EXPECT_EQ(kernel<float(float)>("replaced")(1.0F), 8.0F);
    EXPECT_EQ(kernel<float(float)>("twice")(4.0F), 8.0F);
}

}  // namespace foreign_code_test
}  // namespace gloam::check
