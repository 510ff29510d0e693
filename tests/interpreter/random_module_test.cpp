// SPDX-License-Identifier: MIT
// Random functions whose operations have one legal result each: every device at hand, the module after each
// compiler, and modules changed without a change of meaning, all give what the interpreter gives.
#include "check/own_function.hpp"
#include "check/run.hpp"
#include "module/metamorphic.hpp"
#include "module/spirv.hpp"
#include "support/devices.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam::random_module_test {

using check::Word;

constexpr std::size_t inputs_of_each = 64;

// A random function in a lab, compiled strictly.
struct Subject {
    Subject(std::uint64_t seed, shader::Variant variant, const std::shared_ptr<backend::Backend>& device)
        : text(test::random_function(seed)),
          lab({.variant = strict(std::move(variant)),
               .excerpts = shader::excerpts({file, text}, {}).functions},
              device),
          question(check::question_of(lab, file,
                                      check::own_functions(lab.options(), file, {name(seed)}).found.at(0),
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

// The outputs of a module, rounded correctly.
std::vector<Word> outputs_of(const Subject& subject, check::KernelModule module, const shader::Spirv& spirv) {
    module.spirv = spirv;
    const check::Domain::Inputs inputs = subject.question.domain.draw(inputs_of_each, 1);
    return subject.lab.core(std::move(module)).run(inputs.words, inputs.count()).outputs;
}

// All changes of a seed together, and some of them alone, in modules with variables and in those without.
TEST_P(RandomModule, MeansTheSameToTheBitWhenItIsChangedWithoutAChangeOfMeaning) {
    std::vector<std::size_t> together(shader::metamorphic_changes);
    std::iota(together.begin(), together.end(), 0U);
    for (const std::uint64_t seed : seeds()) {
        std::vector<std::vector<std::size_t>> tried{together};
        for (std::size_t i = seed % 6; i < together.size(); i += 6) tried.push_back({i});
        for (const char* variant : {"strict", "optimized"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Question& q = subject.question;
            const check::KernelModule module = subject.lab.kernel(q.file, q.function, q.signature).module();
            const std::vector<Word> want = outputs_of(subject, module, module.spirv);
            for (const std::vector<std::size_t>& positions : tried) {
                const auto changed = shader::metamorphic(module.spirv, seed, positions);
                SCOPED_TRACE(variant + (", seed " + std::to_string(seed)) + " " +
                             testing::PrintToString(changed.changes));
                ASSERT_NO_THROW(shader::validate(changed.module));
                EXPECT_EQ(outputs_of(subject, module, changed.module), want);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 3));

}  // namespace gloam::random_module_test
