// SPDX-License-Identifier: MIT
// Faults planted in compilers are found: as a step that gloam takes with a module, and as a layer in front of
// a driver, which rewrites the modules that it is given.
#include <GLSL.std.450.h>
#include <fmt/format.h>
#include <spirv.h>

#include "interpreter/program.hpp"
#include "judge/run.hpp"
#include "module/include.hpp"
#include "module/module.hpp"
#include "module/spirv.hpp"
#include "subject/own_function.hpp"
#include "support/changed_device.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam::judge::planted_compiler_test {
namespace {

using namespace module;
using namespace subject;

using module::Instruction;
using module::Spirv;

// Faults as compilers have them, planted in modules: each changes every instruction that it applies to.

// An instruction of a module.
struct Location {
    const Instruction& at;
    std::size_t number;                               // among those of its opcode, from 1
    const std::map<std::uint32_t, Instruction>& all;  // the instruction that defines each ID

    // The definition of an operand, if it has that opcode; else null.
    [[nodiscard]] const Instruction* operand(std::size_t word, std::uint32_t opcode) const {
        const auto found = all.find(at.word(word));
        return found == all.end() || found->second.opcode != opcode ? nullptr : &found->second;
    }
};

struct CompilerFault {
    std::string name;
    std::uint32_t opcode;
    std::function<void(const Location&, Spirv& words)> change;  // to no words: the instruction is left out
    // Whether a driver shows it. Not one that only changes a rounding, and not one that makes loops that
    // never end, which some drivers do not survive.
    bool in_a_driver = true;

    [[nodiscard]] Spirv plant(const Spirv& module) const {
        std::map<std::uint32_t, Instruction> all;
        for (const Instruction& one : module::instructions(module)) {
            const auto [result, type] = module::spirv::result_shape(one.opcode);
            if (result) all[one.word(type ? 2 : 1)] = one;
        }
        Spirv changed(module.begin(), module.begin() + 5);
        std::size_t number = 0;
        for (const Instruction& one : module::instructions(module)) {
            Spirv words(one.words.begin(), one.words.end());
            if (one.opcode == opcode) change({one, ++number, all}, words);
            changed.insert(changed.end(), words.begin(), words.end());
        }
        return changed;
    }
};

// Changes of an instruction.

auto swap(std::size_t a, std::size_t b) {
    return [=](const Location&, Spirv& words) {
        if (words.size() > std::max(a, b)) std::swap(words[a], words[b]);
    };
}
auto opcode(std::uint32_t other) {
    return [=](const Location&, Spirv& words) { words[0] = (words[0] & 0xffff0000U) | other; };
}
auto function(std::uint32_t from, std::uint32_t to) {
    return [=](const Location&, Spirv& words) {
        if (words[4] == from) words[4] = to;
    };
}
auto added(std::uint32_t type_opcode, std::uint32_t difference) {
    return [=](const Location& location, Spirv& words) {
        if (location.operand(1, type_opcode) != nullptr && words[3] > 7) words[3] += difference;
    };
}
auto every(std::size_t nth) {
    return [=](const Location& location, Spirv& words) {
        if (location.number % nth == 0) words.clear();
    };
}

// The first sum of (a + b) + c, if c is known where that is made; else null.
const Instruction* inner_sum(const Location& sum) {
    const Instruction* const inner = sum.operand(3, SpvOpFAdd);
    const auto other = sum.all.find(sum.at.word(4));
    const bool known = inner != nullptr && other != sum.all.end() && other->second.at < inner->at;
    return known ? inner : nullptr;
}
// (a + b) + c as (c + b) + a.
void reassociate(const Location& sum, Spirv& words) {
    for (const auto& [id, outer] : sum.all) {
        const Instruction* const inner = outer.opcode == SpvOpFAdd ? inner_sum({outer, 0, sum.all}) : nullptr;
        if (inner != nullptr && inner->at == sum.at.at) words[3] = outer.word(4);
    }
    if (const Instruction* const inner = inner_sum(sum)) words[4] = inner->word(3);
}
// a * b + c as one rounding.
void contract(const Location& sum, Spirv& words) {
    const Instruction* const product = sum.operand(3, SpvOpFMul);
    if (product == nullptr) return;
    for (const auto& [id, one] : sum.all)
        if (one.opcode == SpvOpExtInstImport)
            words = module::instruction(
                SpvOpExtInst, std::vector<std::uint32_t>{sum.at.word(1), sum.at.word(2), id, GLSLstd450Fma,
                                                         product->word(3), product->word(4), sum.at.word(4)});
}
void transpose(const Location& location, Spirv& words) {
    opcode(SpvOpVectorTimesMatrix)(location, words);
    std::swap(words[3], words[4]);
}
void swap_bounds(const Location&, Spirv& words) {
    if (words[4] == GLSLstd450FClamp) std::swap(words[6], words[7]);
}
void swap_sources(const Location&, Spirv& words) {
    if (words.size() == 7) std::swap(words[3], words[5]);
}
void extract_other(const Location&, Spirv& words) {
    if (words.size() == 5 && words[4] < 2) words[4] ^= 1U;
}
void swap_arguments(const Location& location, Spirv& words) {
    for (std::size_t a = 4; a + 1 < words.size(); ++a)
        if (location.all.at(words[a]).word(1) == location.all.at(words[a + 1]).word(1))
            std::swap(words[a], words[a + 1]);
}
// Of a variable of the function: the constant before, of the same type.
void other_element(const Location& location, Spirv& words) {
    const Instruction* const variable = location.operand(3, SpvOpVariable);
    const Instruction* const index = location.operand(4, SpvOpConstant);
    if (variable == nullptr || variable->word(3) != SpvStorageClassFunction || index == nullptr ||
        words.size() != 5)
        return;
    for (const auto& [id, other] : location.all)
        if (other.opcode == SpvOpConstant && other.word(1) == index->word(1) &&
            other.word(3) + 1 == index->word(3))
            words[4] = id;
}

std::vector<CompilerFault> compiler_faults() {
    return {{"operands of an integer difference swapped", SpvOpISub, swap(3, 4)},
            {"operands of a difference swapped", SpvOpFSub, swap(3, 4)},
            {"operands of a select swapped", SpvOpSelect, swap(4, 5)},
            {"quotient of the operands swapped", SpvOpSDiv, swap(3, 4)},
            {"signed quotient as unsigned", SpvOpSDiv, opcode(SpvOpUDiv)},
            {"signed shift as unsigned", SpvOpShiftRightArithmetic, opcode(SpvOpShiftRightLogical)},
            {"signed less as unsigned", SpvOpSLessThan, opcode(SpvOpULessThan)},
            {"less as less or equal", SpvOpSLessThan, opcode(SpvOpSLessThanEqual)},
            {"greater turned round without its operands", SpvOpSGreaterThan, opcode(SpvOpSLessThan)},
            {"and as or", SpvOpLogicalAnd, opcode(SpvOpLogicalOr)},
            {"bits of and as or", SpvOpBitwiseAnd, opcode(SpvOpBitwiseOr)},
            {"not left out", SpvOpLogicalNot, opcode(SpvOpCopyObject)},
            {"product as a sum", SpvOpIMul, opcode(SpvOpIAdd)},
            {"signed number read as unsigned", SpvOpConvertSToF, opcode(SpvOpConvertUToF)},
            {"signed field as unsigned", SpvOpBitFieldSExtract, opcode(SpvOpBitFieldUExtract)},
            {"matrix transposed", SpvOpMatrixTimesVector, transpose},
            {"smaller as larger", SpvOpExtInst, function(GLSLstd450FMin, GLSLstd450FMax)},
            {"floor as trunc", SpvOpExtInst, function(GLSLstd450Floor, GLSLstd450Trunc)},
            {"sign for magnitude", SpvOpExtInst, function(GLSLstd450FAbs, GLSLstd450FSign)},
            {"bounds of a clamp swapped", SpvOpExtInst, swap_bounds},
            {"float constants folded one bit off", SpvOpConstant, added(SpvOpTypeFloat, 1)},
            {"integer constants folded one off", SpvOpConstant, added(SpvOpTypeInt, 1)},
            {"sums reassociated although precise", SpvOpFAdd, reassociate},
            {"product and sum contracted although precise", SpvOpFAdd, contract, false},
            {"ways of a branch swapped", SpvOpBranchConditional, swap(2, 3)},
            {"default and case of a switch swapped", SpvOpSwitch, swap(2, 4)},
            {"operands of a phi swapped", SpvOpPhi, swap_sources, false},
            {"other component extracted", SpvOpCompositeExtract, extract_other},
            {"components shuffled otherwise", SpvOpVectorShuffle, swap(5, 6)},
            {"element of an array one off", SpvOpAccessChain, other_element},
            {"arguments of a call swapped", SpvOpFunctionCall, swap_arguments},
            {"every third store dropped", SpvOpStore, every(3)},
            {"every fifth store dropped", SpvOpStore, every(5)}};
}

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
            module::Variant variant = module::variant(name);
            variant.strict = true;
            const Lab lab({.variant = variant, .file = file}, interpreter_backend());
            for (const OwnFunction& own : own_functions(lab.options()).found) {
                if (own.name.starts_with("random_") == ranges.empty()) continue;
                Question question = question_of(lab, own, ranges);
                const KernelCore kernel = lab.kernel(own.file, own.name, question.signature);
                all.push_back({std::move(question), kernel.module()});
            }
        }
    };
    const std::string file = FIXTURES "/compiled.glsl";
    add(file, module::read_text(file), {});
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        add("random.glsl", test::random_function(seed), {range_from(test::random_function_range)});
    return all;
}

bool is_found(const Question& question, const KernelCore& kernel, std::uint64_t seed) {
    const Domain::Inputs inputs = question.domain.draw(inputs_of_each, seed);
    try {
        const KernelCore::Result result = kernel.run(inputs.words, inputs.count());
        return judge(question, {.edges = false, .criterion = Criterion::rules, .modules = result.modules},
                     inputs, result.outputs)
                   .outside() > 0;
    } catch (const backend::Fault&) {  // it never ends, or reads outside an array
        return true;
    }
}

TEST(PlantedCompiler, EachFaultIsFound) {
    const std::vector<Subject> all = subjects();
    const auto look = [&all](const CompilerFault& fault, const char* where, const auto& kernel_of) {
        std::uint64_t seed = 0;
        EXPECT_TRUE(
            std::ranges::any_of(all,
                                [&](const Subject& subject) {
                                    return fault.plant(subject.module.spirv) != subject.module.spirv &&
                                           is_found(subject.question, kernel_of(subject.module), seed++);
                                }))
            << fault.name << " " << where;
    };
    const std::shared_ptr<backend::Backend> exact = interpreter_backend();
    for (const CompilerFault& fault : compiler_faults()) {
        look(fault, "as a step", [&](KernelModule module) {
            module.before = module.spirv;
            module.rounds_to_even = true;
            module.spirv = fault.plant(module.spirv);
            return KernelCore(*exact, std::move(module));
        });
        if (!fault.in_a_driver) continue;
        const test::ChangedDevice faulty(test::SharedDevice::get(), {.compiled = [&](const Spirv& module) {
                                             return fault.plant(module);
                                         }});
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
            module::Variant variant = module::variant("strict");
            const Lab lab(
                {.variant = variant, .file = std::make_shared<const OwnFile>("f.glsl", text, no_roots)},
                interpreter_backend());
            const OwnFunction own = own_functions(lab.options()).found.at(0);
            if (question != nullptr) *question = question_of(lab, own, {});
            return lab.kernel("f.glsl", "f", own.signature()).module();
        };
        Question question;
        KernelModule module = kernel(before, &question);
        module.before = std::exchange(module.spirv, kernel(after, nullptr).spirv);
        module.rounds_to_even = true;
        EXPECT_EQ(is_found(question, KernelCore(*interpreter_backend(), std::move(module)), 0),
                  std::string_view(after).find("isnan") != std::string_view::npos)
            << after;
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
        const Lab lab({.variant = module::variant(name), .file = file}, device);
        const OwnFunction own = own_functions(lab.options()).found.at(1);
        const Question question = question_of(lab, own, {{"rounds", {0, 5}}});
        return run(lab, question, {.inputs = inputs_of_each});
    };
    for (const auto& [variant, step] :
         {std::pair{"optimized", "spirv-opt -O"}, {"small", "spirv-opt -Os"}, {"literals", "spirv-opt -O"}}) {
        const Answer as_step = answer_in(fmt::format("shipped | {}", step), interpreter_backend());
        for (const auto& device :
             {interpreter_backend(), std::shared_ptr<backend::Backend>(test::SharedDevice::get())}) {
            const Answer answer = answer_in(variant, device);
            EXPECT_EQ(answer.failed(), as_step.failed()) << variant << " on " << device->info().name;
            EXPECT_EQ(answer.story.find("SPIRV-Tools is at fault") != std::string::npos, answer.failed())
                << answer.story;
        }
    }
}

}  // namespace
}  // namespace gloam::judge::planted_compiler_test
