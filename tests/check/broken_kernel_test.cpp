// SPDX-License-Identifier: MIT
// Broken kernels: the canaries and guards must report them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/lab.hpp"

namespace gloam::check {
namespace broken_kernel_test {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::size_t input_count = 100;

class BrokenKernelTest : public testing::Test {
  protected:
    Lab lab = test::make_lab();

    // A kernel of one input word and one output word with the harness's interface and the given body of main.
    KernelCore kernel(const std::string& body) {
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
        return {lab.device(), {.spirv = std::move(spirv), .input_words = 1, .output_words = 1}, "broken"};
    }

    static KernelCore::Result run(const KernelCore& core) {
        const std::vector<Word> inputs(input_count, 7U);
        return core.run(inputs, input_count);
    }
};

TEST_F(BrokenKernelTest, AHonestKernelPasses) {
    const auto core = kernel("outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i;");
    EXPECT_EQ(run(core).outputs, std::vector<Word>(input_count, 7U));
}

TEST_F(BrokenKernelTest, AKernelThatNeverWritesIsCaught) {
    const auto core = kernel("faults[0] += inputs[i] * 0u;");
    EXPECT_THAT([&] { (void)run(core); },
                ThrowsMessage<KernelError>(HasSubstr("did not finish for input 0")));
}

TEST_F(BrokenKernelTest, OneInvocationThatStopsEarlyIsNamed) {
    const auto core =
        kernel("if (i == 63u) return; outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i;");
    EXPECT_THAT([&] { (void)run(core); },
                ThrowsMessage<KernelError>(HasSubstr("did not finish for input 63 of 100")));
}

TEST_F(BrokenKernelTest, ACanaryOfAnotherRunIsStale) {
    const auto core = kernel("outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = 0x12345678u ^ i;");
    EXPECT_THAT([&] { (void)run(core); }, ThrowsMessage<KernelError>(HasSubstr("canary")));
}

TEST_F(BrokenKernelTest, AWriteBehindTheOutputsIsCaught) {
    const auto core = kernel(
        "outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i; if (i == 5u) outputs[2u * count + "
        "3u] = 1u;");
    EXPECT_THAT([&] { (void)run(core); }, ThrowsMessage<KernelError>(HasSubstr("wrote outside its outputs")));
}

TEST_F(BrokenKernelTest, InputsOfTheWrongLengthAreRefused) {
    const auto core = kernel("outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i;");
    const std::vector<Word> inputs(3, 0U);
    EXPECT_THAT([&] { (void)core.run(inputs, 4); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("4 words, got 3")));
}

}  // namespace broken_kernel_test
}  // namespace gloam::check
