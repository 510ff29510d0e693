// SPDX-License-Identifier: MIT
// Random functions whose operations have one legal result each: every device at hand, the module after each
// compiler, and modules changed without a change of meaning, all give what the interpreter gives.
#include <gtest/gtest.h>

#include "check/interpreted_kernel.hpp"
#include "check/own_function.hpp"
#include "check/random_function.hpp"
#include "check/run.hpp"
#include "shader/metamorphic.hpp"
#include "shader/pack.hpp"
#include "shader/spirv.hpp"
#include "support/devices.hpp"

namespace gloam {
namespace random_module_test {

using check::Word;

constexpr std::size_t inputs_of_each = 64;

// A random function in a lab, compiled strictly.
struct Subject {
    Subject(std::uint64_t seed, shader::Variant variant, const std::shared_ptr<backend::Backend>& device)
        : text(check::random_function(seed)),
          lab({.variant = strict(std::move(variant)),
               .excerpts = shader::excerpts({file, text}, {}).functions},
              device),
          question(check::question_of(lab, file,
                                      check::own_functions(lab.options(), file, {name(seed)}).found.at(0),
                                      {check::range_from(check::random_function_range)})) {}

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
        for (const char* variant : {"strict | spirv-opt -O", "strict | spirv-opt -Os",
                                    "strict | spirv-cross glsl", "strict | spirv-cross hlsl"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Answer answer = subject.answer();
            EXPECT_TRUE(answer.passed()) << variant << "\n" << answer << subject.text;
        }
    }
}

// The outputs of a module, rounded correctly.
std::vector<Word> outputs_of(const Subject& subject, check::KernelModule module, const shader::Spirv& spirv) {
    module.spirv = spirv;
    const check::Domain::Inputs inputs = subject.question.domain.draw(inputs_of_each, 1);
    return subject.lab.core(std::move(module), "it").run(inputs.words, inputs.count()).outputs;
}

// Each change of its own, and all of a seed together, in modules with variables and in those without.
TEST_P(RandomModule, MeansTheSameToTheBitWhenItIsChangedWithoutAChangeOfMeaning) {
    std::vector<std::size_t> together(shader::metamorphic_changes);
    for (std::size_t i = 0; i < together.size(); ++i) together[i] = i;
    for (const std::uint64_t seed : seeds()) {
        for (const char* variant : {"strict", "optimized"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Question& q = subject.question;
            const check::KernelModule module = subject.lab.kernel(q.file, q.function, q.signature).module();
            const std::vector<Word> want = outputs_of(subject, module, module.spirv);
            for (std::size_t i = 0; i <= together.size(); ++i) {
                const auto changed =
                    shader::metamorphic(module.spirv, seed, i < together.size() ? std::vector{i} : together);
                ASSERT_NO_THROW(shader::validate(changed.module))
                    << variant << ", seed " << seed << " " << testing::PrintToString(changed.changes);
                EXPECT_EQ(outputs_of(subject, module, changed.module), want)
                    << variant << ", seed " << seed << " " << testing::PrintToString(changed.changes);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 5));

}  // namespace random_module_test
}  // namespace gloam
