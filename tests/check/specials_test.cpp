// SPDX-License-Identifier: MIT
// What is permitted where a NaN or an infinity meets an operation.
#include "check/interpretation.hpp"
#include "check/question.hpp"
#include "support/lab.hpp"

namespace gloam::check::specials_test {

// What a driver may return where SignedZeroInfNanPreserve binds none of the operations, or all.
TEST(Specials, AreJudgedByInstruction) {
    const Lab lab = test::make_lab(FIXTURES, shader::variant("strict"));
    const auto forbids = [&lab](const char* function, float x, float got) {
        const Signature signature = SignatureOf<float(float, float)>::describe();
        const KernelCore kernel = lab.kernel("rules.glsl", function, signature);
        const std::vector<Word> words{to_word(x), to_word(0.0F)};
        const KernelCore::Result result = kernel.run(words, 1);
        const Decoded decoded(result.modules, {});
        const std::vector<shader::Scalar> outputs = signature.output_scalars();
        Interpretation rules(decoded, outputs, outputs.size());
        const InputRow row{.index = 0, .words = words};
        const std::vector<Word> given{to_word(got)};
        return !rules.is_exact(row, given) && !rules.is_permitted(row, given);
    };
    const float nan = std::nanf("");
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(forbids("abs_is_number", nan, 1.0F)) << "no wording lists FAbs, the first no comparison";
    EXPECT_FALSE(forbids("abs_is_number", nan, 0.0F));
    EXPECT_TRUE(forbids("abs_is_number", nan, 0.5F));
    EXPECT_TRUE(forbids("abs_is_number", -2.0F, 0.0F));
    EXPECT_FALSE(forbids("least", infinity, 7.0F)) << "nor FMin";
    EXPECT_TRUE(forbids("least", 5.0F, 7.0F));
    EXPECT_TRUE(forbids("difference", infinity, 7.0F)) << "all list OpFSub";
    EXPECT_FALSE(forbids("difference", infinity, infinity));
    EXPECT_TRUE(forbids("quotient", 1.0F, 5.0F)) << "a division by zero is an infinity";
    EXPECT_FALSE(forbids("quotient", 1.0F, infinity));
    EXPECT_FALSE(forbids("quotient", 1.0F, -infinity));
    EXPECT_FALSE(forbids("quotient", 0.0F, 5.0F));
}

}  // namespace gloam::check::specials_test
