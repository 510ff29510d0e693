// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "check/function.hpp"
#include "check/kernel_code.hpp"
#include "check/lab.hpp"
#include "shader/spirv.hpp"
#include "support/lab.hpp"

namespace gloam::check::constant_kernel_test {

struct Texel {
    float occlusion;
    glm::vec2 moments;
    unsigned index;
    bool valid;
};

// Words of every kind of scalar. In GLSL true is 1; other scalars have any bit pattern except NaN, whose bits
// need not be preserved.
std::vector<Word> some_words(const std::vector<shader::Scalar>& scalars, std::size_t count) {
    constexpr std::array<float, 10> floats{0.0F,     -0.0F,     1.0F / 3.0F, -2.5F,  16777217.0F,
                                           1.2e-38F, 3.402e38F, INFINITY,    -1e-6F, -INFINITY};
    std::vector<Word> words;
    Word bits = 0x9e3779b9U;
    for (std::size_t i = 0; i < count; ++i) {
        for (const shader::Scalar scalar : scalars) {
            bits = bits * 1664525U + 1013904223U;
            if (scalar == shader::Scalar::bool_) words.push_back(bits >> 31U);
            if (scalar == shader::Scalar::int_ || scalar == shader::Scalar::uint_) words.push_back(bits);
            if (scalar == shader::Scalar::float_)
                words.push_back(std::bit_cast<Word>(floats[(bits >> 16U) % floats.size()]));
        }
    }
    return words;
}

class ConstantKernelTest : public testing::TestWithParam<const char*> {
  protected:
    static Lab make_lab(const char* variant) { return test::make_lab(FIXTURES, shader::variant(variant)); }

    Lab plain = make_lab("shipped");
    Lab lab = make_lab(GetParam());

    template <class Type>
    ConstantKernel kernel(const std::string& function, const std::string& file = "types.glsl") {
        return {lab, file, function, SignatureOf<Type>::describe()};
    }

    // Expects the outputs that the kernel has with its inputs in memory.
    template <class Type>
    void expect_same(const std::string& function, std::size_t count = 5) {
        const Signature signature = SignatureOf<Type>::describe();
        const std::vector<Word> words = some_words(signature.input_scalars(), count);
        const auto expected = plain.kernel("types.glsl", function, signature).run(words, count);
        const auto constant = kernel<Type>(function).run(words, count);
        EXPECT_EQ(constant.outputs, expected.outputs) << function;
        EXPECT_EQ(constant.outputs.size(), count * signature.output_words()) << function;
        EXPECT_NO_THROW(lab.require_silent_validation()) << function;
    }
};

TEST_P(ConstantKernelTest, GivesWhatTheKernelGivesForEveryKindOfParameter) {
    expect_same<int(int)>("negate_int");
    expect_same<unsigned(unsigned, unsigned)>("shift_uint", 0);
    expect_same<bool(bool, bool)>("both");
    expect_same<glm::ivec2(glm::ivec2)>("swap_ints");
    expect_same<glm::bvec3(glm::bvec3)>("flip_bools");
    expect_same<glm::uvec4(glm::uvec4)>("reverse_uints");
    expect_same<glm::mat3x2(glm::mat2x3)>("transpose_matrix");
    expect_same<Texel(Texel, unsigned)>("advance");
    expect_same<float(float)>("overloaded");
    expect_same<float()>("answer");
    expect_same<bool(float, Out<float>, float&)>("split");
    expect_same<void(float, Out<glm::vec2>)>("nothing_returned");
}

TEST_P(ConstantKernelTest, AsManyInputsAsAllowedKeepTheirOrder) {
    expect_same<float(float)>("overloaded", ConstantKernel::most_inputs);
    expect_same<int(int)>("negate_int", 17);
    const auto negate = kernel<int(int)>("negate_int");
    EXPECT_TRUE(negate.run({}, 0).outputs.empty());
    EXPECT_THROW((void)negate.run(std::vector<Word>(65), 65), std::invalid_argument);
    EXPECT_THROW((void)negate.run(std::vector<Word>(3), 2), std::invalid_argument);
}

TEST_P(ConstantKernelTest, NanArrives) {
    if (!lab.info().float32.preserves_signed_zero_inf_nan)
        GTEST_SKIP() << lab.info().name << " does not promise to keep NaN";
    const std::vector<Word> nans{0x7fc00000U, 0xffc00000U, 0x7f800001U, 0x7fffffffU};
    const auto result = kernel<float(float)>("overloaded").run(nans, nans.size());
    ASSERT_EQ(result.outputs.size(), nans.size());
    for (const Word word : result.outputs) EXPECT_TRUE(std::isnan(std::bit_cast<float>(word))) << word;
}

TEST_P(ConstantKernelTest, ImagesAreServed) {
    const ImageSet images{
        {"fetch_depth", make_image<float>({5, 4}, [](glm::ivec2 p) { return float(p.x + 10 * p.y); })},
        {"fetch_normal", make_image<glm::vec3>({5, 4}, [](glm::ivec2 p) { return glm::vec3(0, 0, p.x); })}};
    const Signature signature = SignatureOf<float(glm::ivec2)>::describe();
    const std::vector<Word> inside{1, 1, 3, 2, 2, 1};
    const auto expected = plain.kernel("images.glsl", "plus", signature).run(inside, 3, images);
    const auto plus = kernel<float(glm::ivec2)>("plus", "images.glsl");
    EXPECT_EQ(plus.run(inside, 3, images).outputs, expected.outputs);
    EXPECT_EQ(std::bit_cast<float>(expected.outputs[0]), 55.0F);

    std::vector<Word> outside;
    for (Word i = 0; i < 20; ++i) outside.insert(outside.end(), {i == 18 ? 4U : 1U, 1U});
    const auto fault = plus.run(outside, 20, images).fault;
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->input, 18U);
    EXPECT_EQ(fault->pixel, glm::ivec2(5, 1));
    EXPECT_THROW((void)plus.run(inside, 3), std::invalid_argument) << "no image given";
}

TEST_P(ConstantKernelTest, StoresOfAllModulesAreKept) {
    const ImageSet images{
        {"store_value", make_image<glm::vec2>({20, 1}, [](auto) { return glm::vec2(-1); })}};
    std::vector<Word> words;
    for (Word x = 0; x < 20; ++x) words.insert(words.end(), {x, 0, 0, 0});
    const auto store = kernel<float(glm::ivec2, glm::ivec2)>("store_at", "stores.glsl");
    const auto stored = store.run(words, 20, images).stored;
    ASSERT_EQ(stored.count("store_value"), 1U);
    for (int x = 0; x < 20; ++x) EXPECT_EQ(stored.at("store_value").at<glm::vec2>({x, 0}), glm::vec2(x, 0));
}

TEST_P(ConstantKernelTest, ErrorsAreThoseOfAKernel) {
    EXPECT_THROW((void)kernel<float(float)>("no_such"), std::invalid_argument);
    EXPECT_THROW((void)kernel<float(float)>("negate_int"), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Variant, ConstantKernelTest, testing::Values("literals", "specialization"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ConstantKernel, NeedsAVariantWithConstants) {
    const Lab lab = test::make_lab(FIXTURES);
    EXPECT_THROW(ConstantKernel(lab, "types.glsl", "negate_int", SignatureOf<int(int)>::describe()),
                 std::invalid_argument);
}

TEST(ConstantCode, LiteralsAreExact) {
    using shader::Scalar;
    const auto of = [](Scalar scalar, Word word) { return literal(scalar, word); };
    const auto of_float = [&](float value) { return of(Scalar::float_, std::bit_cast<Word>(value)); };
    EXPECT_EQ(of_float(1.0F), "1.0");
    EXPECT_EQ(of_float(-0.0F), "-0.0");
    EXPECT_EQ(of_float(1e20F), "1.0000000200408773e+20");
    EXPECT_EQ(of_float(INFINITY), "uintBitsToFloat(0x7f800000u)");
    EXPECT_EQ(of(Scalar::float_, 0x7fc00001U), "uintBitsToFloat(0x7fc00001u)");
    EXPECT_EQ(of(Scalar::int_, 0x80000000U), "int(0x80000000u)");
    EXPECT_EQ(of(Scalar::uint_, 7U), "0x00000007u");
    EXPECT_EQ(of(Scalar::bool_, 2U), "true");
    EXPECT_EQ(of(Scalar::bool_, 0U), "false");
    Word bits = 1;
    for (int i = 0; i < 10'000; ++i) {
        bits = bits * 1664525U + 1013904223U;
        const auto value = std::bit_cast<float>(bits);
        if (!std::isfinite(value)) continue;
        EXPECT_EQ(std::bit_cast<Word>(static_cast<float>(std::stod(of_float(value)))), bits);
    }
}

std::string module_of(const char* variant, bool literals) {
    const Lab lab = test::make_lab(FIXTURES, shader::variant(variant));
    KernelSource source = lab.source("wrong.glsl", "weight", SignatureOf<float(float, float)>::describe());
    source.preserve_nan = false;  // as ConstantKernel has it
    const std::vector<Word> inputs{std::bit_cast<Word>(0.3F), std::bit_cast<Word>(0.7F)};
    const std::string text =
        literals ? literal_kernel_code(source, inputs, 1) : specialized_kernel_code(source, 1);
    return shader::disassemble(lab.compile({.name = "constants", .text = text}));
}

TEST(ConstantCode, TheCompilerFoldsLiterals) {
    EXPECT_THAT(module_of("literals", true), Not(AnyOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul"))));
    EXPECT_THAT(module_of("shipped", true), AllOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul")));
}

TEST(ConstantCode, SpecializationConstantsAreLeftToTheDriver) {
    EXPECT_THAT(module_of("specialization", false),
                AllOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul"), HasSubstr("SpecId 0"), HasSubstr("SpecId 1"),
                      Not(HasSubstr("SpecId 2"))));
}

// Broken kernels, with the body of main() and what the canaries and guards report: one word in, one out.
TEST(BrokenKernels, AreCaught) {
    constexpr std::size_t count = 100;
    const Lab lab = test::make_lab();
    const auto kernel = [&](const std::string& body) {
        const std::string text = fmt::format(
            "#version 450\n"
            "layout(local_size_x = 64) in;\n"
            "layout(push_constant) uniform KernelRun {{ uint count; uint row_length; uint canary; }};\n"
            "layout(std430, binding = 0) readonly buffer Inputs {{ uint inputs[]; }};\n"
            "layout(std430, binding = 1) buffer Outputs {{ uint outputs[]; }};\n"
            "layout(std430, binding = 2) buffer Faults {{ uint faults[]; }};\n"
            "void main() {{ uint i = gl_GlobalInvocationID.x; if (i >= count) return; {} }}\n",
            body);
        shader::Spirv spirv = shader::compile({.name = "broken kernel", .text = text}, {});
        return lab.core({{.spirv = std::move(spirv), .input_words = 1, .output_words = 1, .name = "broken"}});
    };
    const std::vector<Word> inputs(count, 7U);
    const std::string right = "outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i;";
    EXPECT_EQ(kernel(right).run(inputs, count).outputs, inputs);
    const std::pair<std::string, const char*> rows[] = {
        {"faults[0] += inputs[i] * 0u;", "did not finish for input 0"},
        {"if (i == 63u) return; " + right, "did not finish for input 63 of 100"},
        {"outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = 0x12345678u ^ i;", "canary"},
        {right + " if (i == 5u) outputs[2u * count + 3u] = 1u;", "wrote outside its outputs"}};
    for (const auto& [body, error] : rows)
        expect_error<backend::Fault>([&] { (void)kernel(body).run(inputs, count); }, {error});
    expect_error<std::invalid_argument>([&] { (void)kernel(right).run(inputs, 4); }, {"4 words, got 100"});
}

}  // namespace gloam::check::constant_kernel_test
