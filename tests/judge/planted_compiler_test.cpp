// SPDX-License-Identifier: MIT
// Faults planted in compilers are found: as a step that gloam takes with a module, and as a layer in front of
// a driver, which rewrites the modules that it is given. Each row says what finding one took.
#include <fmt/format.h>
#include <array>
#include <chrono>

#include "interpreter/program.hpp"
#include "judge/compiler_faults.hpp"
#include "judge/run.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "subject/own_function.hpp"
#include "support/changed_device.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam::check::planted_compiler_test {
namespace {

constexpr std::size_t inputs_of_each = 64;
const std::vector<std::filesystem::path> no_roots;

// A function to compile: its kernel, and the question that judges the results.
struct Subject {
    Question question;
    KernelModule module;
};

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    const auto add = [&](const std::filesystem::path& path, const std::string& text, const Ranges& ranges) {
        const auto file = std::make_shared<const OwnFile>(path, text, no_roots);
        for (const char* name : {"optimized", "strict"}) {
            shader::Variant variant = shader::variant(name);
            variant.strict = true;
            const Lab lab({.variant = variant, .file = file}, interpreter());
            for (const OwnFunction& own : own_functions(lab.options()).found) {
                if (own.name.starts_with("random_") == ranges.empty()) continue;
                Question question = question_of(lab, own, ranges);
                const KernelCore kernel = lab.kernel(own.file, own.name, question.signature);
                all.push_back({std::move(question), kernel.module()});
            }
        }
    };
    const std::string file = FIXTURES "/compiled.glsl";
    add(file, shader::read_text(file), {});
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        add("random.glsl", test::random_function(seed), {range_from(test::random_function_range)});
    return all;
}

// What it took until a result was outside.
struct Found {
    std::size_t modules = 0;
    std::size_t inputs = 0;
    bool found = false;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

    void add(const Question& question, const KernelCore& kernel) {
        const Domain::Inputs inputs = question.domain.draw(inputs_of_each, modules);
        ++modules;
        this->inputs += inputs.count();
        try {
            const KernelCore::Result result = kernel.run(inputs.words, inputs.count());
            const Answer answer =
                judge(question, {.edges = false, .verdict = Verdict::rules, .modules = result.modules},
                      inputs, result.outputs);
            found = answer.outside() > 0;
        } catch (const backend::Fault&) {  // it never ends, or reads outside an array
            found = true;
        }
    }
    void print(const std::string& fault, const std::string& where) const {
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        fmt::print("{:<50} {:<12} {:>7} modules {:>6} inputs {:>8.3f} s\n", fault, where, modules, inputs,
                   took.count());
    }
};

TEST(PlantedCompiler, EachFaultIsFound) {
    const std::vector<Subject> all = subjects();
    const auto look = [&all](const test::CompilerFault& fault, const std::string& where,
                             const auto& kernel_of) {
        Found found;
        for (const Subject& subject : all) {
            if (fault.plant(subject.module.spirv) == subject.module.spirv) continue;
            found.add(subject.question, kernel_of(subject.module));
            if (found.found) break;
        }
        EXPECT_TRUE(found.found) << fault.name << " " << where;
        found.print(fault.name, where);
    };
    const std::shared_ptr<backend::Backend> exact = interpreter();
    for (const test::CompilerFault& fault : test::compiler_faults()) {
        look(fault, "as a step", [&](KernelModule module) {
            module.before = module.spirv;
            module.rounds_to_even = true;
            module.spirv = fault.plant(module.spirv);
            return KernelCore(*exact, std::move(module));
        });
        if (!fault.in_a_driver) continue;
        const test::ChangedDevice faulty(
            test::SharedDevice::get(),
            {.compiled = [&](const shader::Spirv& module) { return fault.plant(module); }});
        look(fault, "in a driver", [&](KernelModule module) {
            module.before.clear();
            return KernelCore(faulty, std::move(module));
        });
    }
    // What the layers say of planted modules is for no later test of the process.
    (void)test::SharedDevice::get()->take_validation_messages();
}

// The text that a compiler was given, and one that it may make of it: no wording of SignedZeroInfNanPreserve
// before Vulkan 1.4.304 lists comparisons, and none lists step().
TEST(PlantedCompiler, NaNAndInfinityAreItsOwnWhereADeviceMayDoAsItLikes) {
    const std::array<const char*, 2> rows[] = {
        {"float f(float e, float x) { return step(e, x); }",
         "float f(float e, float x) { return x >= e ? 1.0 : 0.0; }"},
        {"bool f(float x, float y) { return x != y; }",
         "bool f(float x, float y) { return x < y || x > y; }"},
        {"float f(float x, float y) { return max(x, y); }",
         "float f(float x, float y) { return x > y ? x : y; }"},
        {"float f(float x, float y) { return x + y; }",
         "float f(float x, float y) { return isnan(x) ? 0.0 : x + y; }"}};
    for (const auto& [before, after] : rows) {
        const auto kernel = [&](const std::string& text, Question* question) {
            shader::Variant variant = shader::variant("strict");
            const Lab lab(
                {.variant = variant, .file = std::make_shared<const OwnFile>("f.glsl", text, no_roots)},
                interpreter());
            const OwnFunction own = own_functions(lab.options()).found.at(0);
            if (question != nullptr) *question = question_of(lab, own, {});
            return lab.kernel("f.glsl", "f", own.signature()).module();
        };
        Question question;
        KernelModule module = kernel(before, &question);
        module.before = std::exchange(module.spirv, kernel(after, nullptr).spirv);
        module.rounds_to_even = true;
        Found found;
        found.add(question, KernelCore(*interpreter(), std::move(module)));
        EXPECT_EQ(found.found, std::string_view(after).find("isnan") != std::string_view::npos) << after;
    }
}

// A shader of which SPIRV-Tools 2023.1 make another one (KhronosGroup/SPIRV-Tools#5815).
constexpr const char* joined = R"(
bool never(int p) { uint z = 0u; return bool(z); }
int joined(int rounds, int p) {
    int a = 0, g = 0, k = 0;
    for (int i = 0; i < rounds; i++)
        if (never(1)) {
            if (never(p)) continue;
            break;
        } else {
            k = a;
            for (int j = 0; j < 2; j++) g = 1;
            k = g | k;
        }
    return k;
})";

// SPIRV-Tools as a step and as a variant have the same faults, whether this release has some or none.
TEST(PlantedCompiler, AVariantOfOurOwnIsJudgedAsAStep) {
    const auto file = std::make_shared<const OwnFile>("joined.glsl", joined, no_roots);
    const auto answer_in = [&](const std::string& name, const std::shared_ptr<backend::Backend>& device) {
        const Lab lab({.variant = shader::variant(name), .file = file}, device);
        const OwnFunction own = own_functions(lab.options()).found.at(1);
        const Question question = question_of(lab, own, {{"rounds", {0, 5}}});
        return run(lab, question, {.inputs = inputs_of_each});
    };
    for (const auto& [variant, step] :
         {std::pair{"optimized", "spirv-opt -O"}, {"small", "spirv-opt -Os"}, {"literals", "spirv-opt -O"}}) {
        const Answer as_step = answer_in(fmt::format("shipped | {}", step), interpreter());
        for (const auto& device :
             {interpreter(), std::shared_ptr<backend::Backend>(test::SharedDevice::get())}) {
            const Answer answer = answer_in(variant, device);
            EXPECT_EQ(answer.failed(), as_step.failed()) << variant << " on " << device->info().name;
            EXPECT_EQ(answer.story.find("SPIRV-Tools is at fault") != std::string::npos, answer.failed())
                << answer.story;
        }
        fmt::print("{}: SPIRV-Tools {}\n", variant, as_step.failed() ? "make another shader" : "are right");
    }
}

}  // namespace
}  // namespace gloam::check::planted_compiler_test
