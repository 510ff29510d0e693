// SPDX-License-Identifier: MIT
// Random functions whose operations have one legal result each: every device at hand, and the module after
// each compiler, give what the interpreter gives.
#include "backend/vulkan/device.hpp"
#include "judge/run.hpp"
#include "subject/own_function.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam::random_module_test {

constexpr std::size_t inputs_of_each = 64;

// A random function in a lab, compiled strictly.
struct Subject {
    Subject(std::uint64_t seed, module::Variant variant, const std::shared_ptr<backend::Backend>& device)
        : text(test::random_function(seed)),
          lab({.variant = strict(std::move(variant)),
               .file = std::make_shared<const subject::OwnFile>(file, text,
                                                                std::vector<std::filesystem::path>{})},
              device),
          question(judge::question_of(lab, subject::own_functions(lab.options(), {name(seed)}).found.at(0),
                                      {subject::range_from(test::random_function_range)})) {}

    static constexpr const char* file = "random.glsl";
    static std::string name(std::uint64_t seed) { return "random_" + std::to_string(seed); }
    static module::Variant strict(module::Variant variant) {
        variant.strict = true;
        return variant;
    }

    [[nodiscard]] judge::Answer answer() const {
        return judge::run(lab, question, {.inputs = inputs_of_each});
    }

    std::string text;
    subject::Lab lab;
    judge::Question question;
};

class RandomModule : public testing::TestWithParam<int> {
  protected:
    // The process knows a browser's SwiftShader by its name then.
    static void SetUpTestSuite() { backend::vulkan::add_swiftshader(); }
    [[nodiscard]] static auto seeds() {
        const std::uint64_t first = static_cast<std::uint64_t>(GetParam()) * 1000U;
        return std::views::iota(first, first + 6);
    }
};

TEST_P(RandomModule, MeansTheSameToEveryDevice) {
    for (const backend::DeviceInfo& info : backend::vulkan::list_devices()) {
        const auto device =
            std::make_shared<backend::vulkan::Device>(backend::vulkan::DeviceOptions{.device = info.name});
        for (const std::uint64_t seed : seeds()) {
            const Subject subject(seed, module::variant("strict"), device);
            const judge::Answer answer = subject.answer();
            ASSERT_TRUE(answer.passed()) << info.name << "\n" << answer << subject.text;
        }
    }
}

// A module after a compiler's steps means what the module before them means.
TEST_P(RandomModule, MeansTheSameWhenItIsOptimised) {
    for (const std::uint64_t seed : seeds()) {
        for (const char* variant : {"strict | spirv-opt -O", "strict | spirv-opt -Os"}) {
            const Subject subject(seed, module::variant(variant), subject::interpreter_backend());
            const judge::Answer answer = subject.answer();
            EXPECT_TRUE(answer.passed()) << variant << "\n" << answer << subject.text;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 3));

}  // namespace gloam::random_module_test
