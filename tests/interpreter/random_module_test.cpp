// SPDX-License-Identifier: MIT
// Random functions whose operations have one legal result each: every device at hand, and the module after
// each compiler, give what the interpreter gives.
#include "judge/run.hpp"
#include "subject/own_function.hpp"
#include "support/devices.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam::random_module_test {

constexpr std::size_t inputs_of_each = 64;

// A random function in a lab, compiled strictly.
struct Subject {
    Subject(std::uint64_t seed, shader::Variant variant, const std::shared_ptr<backend::Backend>& device)
        : text(test::random_function(seed)),
          lab({.variant = strict(std::move(variant)),
               .file =
                   std::make_shared<const check::OwnFile>(file, text, std::vector<std::filesystem::path>{})},
              device),
          question(check::question_of(lab, check::own_functions(lab.options(), {name(seed)}).found.at(0),
                                      {check::range_from(test::random_function_range)})) {}

    static constexpr const char* file = "random.glsl";
    static std::string name(std::uint64_t seed) { return "random_" + std::to_string(seed); }
    static shader::Variant strict(shader::Variant variant) {
        variant.strict = true;
        return variant;
    }

    [[nodiscard]] check::Answer answer() const {
        return check::run(lab, question, {.inputs = inputs_of_each});
    }

    std::string text;
    check::Lab lab;
    check::Question question;
};

class RandomModule : public testing::TestWithParam<int> {
  protected:
    [[nodiscard]] static std::vector<std::uint64_t> seeds() {
        std::vector<std::uint64_t> all(6);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint64_t>(GetParam()) * 1000U + i;
        return all;
    }
};

TEST_P(RandomModule, MeansTheSameToEveryDevice) {
    for (const gpu::DeviceInfo& info : test::devices_at_hand()) {
        const auto device = std::make_shared<gpu::Device>(gpu::DeviceOptions{.device = info.name});
        for (const std::uint64_t seed : seeds()) {
            const Subject subject(seed, shader::variant("strict"), device);
            const check::Answer answer = subject.answer();
            ASSERT_TRUE(answer.passed()) << info.name << "\n" << answer << subject.text;
        }
    }
}

// A module after a compiler's steps means what the module before them means.
TEST_P(RandomModule, MeansTheSameWhenItIsOptimised) {
    for (const std::uint64_t seed : seeds()) {
        for (const char* variant : {"strict | spirv-opt -O", "strict | spirv-opt -Os"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Answer answer = subject.answer();
            EXPECT_TRUE(answer.passed()) << variant << "\n" << answer << subject.text;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 3));

}  // namespace gloam::random_module_test
