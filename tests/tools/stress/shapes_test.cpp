// SPDX-License-Identifier: MIT
#include "stress/shapes.hpp"

#include "support/method_names.hpp"
#include "tools/installation.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::shapes_test {

class ShapesOf : public EachMethod {
  protected:
    static void SetUpTestSuite() {
        EachMethod::SetUpTestSuite();
        effect_.emplace(shapes_effect(bench().context()));
    }
    static void TearDownTestSuite() {
        effect_.reset();
        EachMethod::TearDownTestSuite();
    }
    inline static std::optional<effect::AmbientOcclusion> effect_;
};

TEST_P(ShapesOf, AllAreAsTheyMustBe) {
    expect_all_passed(shapes(context(), *effect_));
}

INSTANTIATE_TEST_SUITE_P(All, ShapesOf, testing::ValuesIn(gloam::test::method_names()),
                         gloam::test::parameter_name);

// A sample that is always blocked, of a method whose tiles are never taken for open, and a pass that leaves
// out the last pixel of each row.
TEST(Shapes, NoticesWhatIsBroken) {
    for (const auto& [file, from, to] :
         {std::array{"gloam/methods/poisson.glsl", "in_front > kernel.bias", "in_front > -10.0"},
          std::array{"passes/ambient_occlusion.comp", "pixel.x < parameters.size.x &&",
                     "pixel.x < parameters.size.x - 1 &&"}}) {
        const gloam::test::Installation broken;
        broken.replace(file, from, to);
        const Bench bench(broken.glsl());
        EXPECT_FALSE(one_size(bench.context_of("poisson"), {9, 8}).passed()) << to;
    }
}

}  // namespace gloam::stress::test::shapes_test
