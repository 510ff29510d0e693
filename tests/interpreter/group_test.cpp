// SPDX-License-Identifier: MIT
// Invocations that run together: shared memory, barriers, subgroups and quads; races and barriers that not
// all reach.
#include "interpreter/shader_run.hpp"
#include "support/shared_device.hpp"

namespace gloam::group_test {

using interpreter::Error;
using interpreter::Machine;
using interpreter::Order;
using interpreter::Program;

constexpr Word lanes = 16;

// A group of 16 that reads and writes one word each: x() and put(w); `shared` stands before main().
std::string group_shader(const std::string& shared, const std::string& body) {
    return "#version 450\n"
           "#extension GL_KHR_shader_subgroup_arithmetic : require\n"
           "#extension GL_KHR_shader_subgroup_ballot : require\n"
           "#extension GL_KHR_shader_subgroup_vote : require\n"
           "#extension GL_KHR_shader_subgroup_shuffle : require\n"
           "#extension GL_KHR_shader_subgroup_shuffle_relative : require\n"
           "#extension GL_KHR_shader_subgroup_quad : require\n"
           "layout(local_size_x = 8, local_size_y = 2) in;\n"
           "layout(std430, binding = 0) readonly buffer In { uint in_words[]; };\n"
           "layout(std430, binding = 1) buffer Out { uint out_words[]; };\n"
           "uint x() { return in_words[gl_LocalInvocationIndex]; }\n"
           "void put(uint w) { out_words[gl_LocalInvocationIndex] = w; }\n" +
           shared + "\nvoid main() {\n    uint at = gl_LocalInvocationIndex;\n" + body + "}\n";
}

module::Spirv group_module(const std::string& shared, const std::string& body,
                           const char* variant = "shipped") {
    return module::compile({.name = "test", .text = group_shader(shared, body)},
                           {.variant = module::variant(variant), .lines = true});
}

std::vector<Word> group_inputs() {
    std::vector<Word> words;
    for (Word lane = 0; lane < lanes; ++lane) words.push_back(lane * 7U % 11U + 3U);
    return words;
}

template <class N>
std::vector<interpreter::Value<N>> values_in_group(const module::Spirv& module, Word subgroup_size,
                                                   Order order = Order::forward) {
    const Program program(module);
    Machine<N> machine(program);
    const std::vector<Word> in = group_inputs();
    const std::vector<Word> none(lanes, 0U);
    machine.bind(0, 0, in);
    machine.bind(0, 1, none);
    machine.set_group({.group_size = {8, 2, 1}, .subgroup_size = subgroup_size}, order);
    machine.run();
    std::vector<interpreter::Value<N>> out;
    for (Word lane = 0; lane < lanes; ++lane) out.push_back(machine.read(0, 1, lane));
    return out;
}

template <class N>
std::vector<Word> in_group(const module::Spirv& module, Word subgroup_size, Order order = Order::forward) {
    std::vector<Word> out;
    for (const auto& value : values_in_group<N>(module, subgroup_size, order)) out.push_back(value.bits());
    return out;
}

std::vector<Word> group_on_device(const module::Spirv& module) {
    return test::on_device(*test::SharedDevice::get(), module,
                           {.inputs = group_inputs(), .input_words = lanes, .output_words = lanes});
}

void expect_as_on_device(const std::string& shared, const std::string& body) {
    const Word size = test::SharedDevice::get()->info().subgroup_size;
    for (const char* variant : {"shipped", "optimized"}) {
        const module::Spirv module = group_module(shared, body, variant);
        const std::vector<Word> expected = group_on_device(module);
        EXPECT_EQ(in_group<float>(module, size), expected) << variant << ": " << body;
        EXPECT_EQ(in_group<double>(module, size, Order::backward), expected) << variant << ": " << body;
    }
}

TEST(Group, SharedMemoryAndBarriersAreThoseOfTheDriver) {
    const std::string shared =
        "struct Pair { uint sum; bool odd; };\nshared Pair pairs[16];\nshared uint count;\n";
    const std::string reduction =
        "pairs[at] = Pair(x(), (x() & 1u) == 1u);\n"
        "if (at == 0u) count = 0u;\n"
        "barrier();\n"
        "for (uint step = 8u; step > 0u; step >>= 1) {\n"
        "    if (at < step) { pairs[at].sum += pairs[at + step].sum; pairs[at].odd = pairs[at].odd != "
        "pairs[at + step].odd; }\n"
        "    barrier();\n"
        "}\n"
        "if (pairs[0].odd) atomicAdd(count, x());\n"
        "barrier();\n"
        "put(pairs[0].sum * 100u + count);\n";
    expect_as_on_device(shared, reduction);
}

TEST(Group, SubgroupOperationsAreThoseOfTheDriver) {
    for (const char* expression : {"subgroupAdd(x())",
                                   "subgroupInclusiveAdd(x())",
                                   "subgroupExclusiveMin(x())",
                                   "subgroupMul(x() & 3u)",
                                   "subgroupMax(int(x()) - 8)",
                                   "subgroupXor(x())",
                                   "subgroupExclusiveOr(x())",
                                   "subgroupAll(x() > 3u)",
                                   "subgroupAny(x() > 12u)",
                                   "subgroupAllEqual(x())",
                                   "subgroupAllEqual(gl_SubgroupSize)",
                                   "subgroupBroadcast(x(), 2u)",
                                   "subgroupBroadcastFirst(x())",
                                   "subgroupShuffle(x(), at & 3u)",
                                   "subgroupShuffleXor(x(), 1u)",
                                   "subgroupBallot(x() > 5u).x",
                                   "subgroupBallotBitCount(subgroupBallot(x() > 5u))",
                                   "subgroupBallotExclusiveBitCount(subgroupBallot(x() > 5u))",
                                   "subgroupBallotFindLSB(subgroupBallot(x() > 5u))",
                                   "subgroupBallotFindMSB(subgroupBallot(x() > 5u))",
                                   "subgroupInverseBallot(uvec4(5u))",
                                   "subgroupBallotBitExtract(uvec4(5u), at & 1u)",
                                   "subgroupQuadBroadcast(x(), 1u)",
                                   "subgroupQuadSwapHorizontal(x())",
                                   "subgroupQuadSwapDiagonal(x())",
                                   "subgroupElect()",
                                   "subgroupShuffleUp(x(), gl_SubgroupInvocationID > 0u ? 1u : 0u)",
                                   "gl_SubgroupInvocationID",
                                   "gl_SubgroupID",
                                   "gl_NumSubgroups",
                                   "gl_SubgroupLtMask.x",
                                   "floatBitsToUint(subgroupMin(float(x())))",
                                   "floatBitsToUint(subgroupAdd(float(x())))",
                                   "uint(dot(subgroupInclusiveMax(vec2(x(), at)), vec2(1, 100)))"})
        expect_as_on_device("", std::string("put(uint(") + expression + "));\n");
}

Error group_error(const std::string& shared, const std::string& body, Order order = Order::forward) {
    SCOPED_TRACE(body);
    return test::error_of([&] { (void)in_group<float>(group_module(shared, body), 4, order); });
}

TEST(Group, RacesAreFoundInEveryOrder) {
    const std::string shared = "shared uint s[16];\nshared uint one;\n";
    struct Planted {
        const char* body;
        const char* variable;
    };
    for (const Planted& planted :
         {Planted{"s[at] = x(); put(s[at ^ 1u]);\n", "\"s\""},                          // no barrier
          {"one = at; barrier(); put(one);\n", "word 0 of \"one\""},                    // two writers
          {"s[at] = x(); barrier(); put(s[(at + 1u) % 16u]); s[at] = 1u;\n", "\"s\""},  // write after read
          {"s[at] = x(); memoryBarrierShared(); put(s[15u - at]);\n", "\"s\""},         // a fence alone
          {"s[at] = x(); subgroupBarrier(); put(s[(at + 4u) % 16u]);\n", "\"s\""},  // of the subgroup only
          {"atomicAdd(one, x()); put(one);\n", "\"one\""},                          // atomic and plain
          {"put(x()); barrier(); put(out_words[at ^ 1u]);\n", "\"Out\""},           // orders shared only
          {"for (uint k = 0u; k < 2u; ++k) { s[at] = k; barrier(); put(s[at ^ 1u]); }\n", "\"s\""}}) {
        for (const Order order : {Order::forward, Order::backward}) {
            const Error error = group_error(shared, planted.body, order);
            EXPECT_EQ(error.kind(), Error::Kind::race) << planted.body;
            EXPECT_THAT(error.what(), HasSubstr(planted.variable)) << planted.body;
            EXPECT_THAT(error.what(), HasSubstr("no barrier")) << planted.body;
        }
    }
}

TEST(Group, WhatBarriersOrderIsNoRace) {
    const std::string shared = "shared uint s[16];\nshared uint one;\n";
    for (const char* body :
         {"s[at] = x(); barrier(); put(s[at ^ 1u]);\n", "s[at] = x(); subgroupBarrier(); put(s[at ^ 1u]);\n",
          "if (at == 0u) one = 0u; barrier(); atomicAdd(one, x()); barrier(); put(one);\n",
          "put(x()); memoryBarrierBuffer(); barrier(); uint w = out_words[at ^ 1u]; memoryBarrierBuffer(); "
          "barrier(); "
          "put(w);\n",
          "for (uint k = 0u; k < 2u; ++k) { s[at] = k; barrier(); put(s[at ^ 1u]); barrier(); }\n"})
        EXPECT_NO_THROW((void)in_group<float>(group_module(shared, body), 4)) << body;
}

TEST(Group, BarriersThatNotAllReachAreFound) {
    const auto divergent = [](const std::string& body) {
        const Error error = group_error("shared uint s[16];\n", body);
        EXPECT_EQ(error.kind(), Error::Kind::divergent_barrier) << body;
        return std::string(error.what());
    };
    EXPECT_THAT(divergent("if (at < 5u) barrier(); put(1u);\n"),
                HasSubstr("invocation 0 waits and which invocation 5 does not reach: it ended"));
    EXPECT_THAT(divergent("if (at < 5u) barrier(); else barrier(); put(1u);\n"),
                HasSubstr("it waits at main (test:"));
    (void)divergent("if (at == 3u) return; barrier(); put(1u);\n");
    EXPECT_THAT(divergent("for (uint k = 0u; k < 3u; ++k) { if (k == at) continue; barrier(); } put(1u);\n"),
                HasSubstr("it waits there in another iteration"));
    (void)divergent("for (uint k = 0u; k < at; ++k) barrier(); put(1u);\n");
}

// Nor those of another branch; and where they come together again.
TEST(Group, InvocationsOfOtherIterationsAreNotHere) {
    for (const char* body :
         {"uint r = 1u; if (at < 3u) r = subgroupAdd(x()); else r = subgroupMax(x()); put(r);\n",
          // Each takes part in the iterations that it does not skip.
          "uint r = 0u; for (uint k = 0u; k < 4u; ++k) { if ((at & 3u) == k) continue; r = r * 7u + "
          "subgroupAdd(x()); } put(r);\n",
          // Behind a loop that they leave one after the other, and a function from which they return early.
          "uint r = 0u; for (uint k = 0u; k < (at & 3u); ++k) r += subgroupAdd(1u); put(r * 100u + "
          "subgroupAdd(x()));\n",
          "uint r = early(x()); put(r * 100u + subgroupAdd(r));\n"})
        expect_as_on_device("uint early(uint v) { if (v > 6u) return 1u; return 2u; }\n", body);
}

TEST(Group, WhatDependsOnTheOrderIsUnspecified) {
    const module::Spirv module =
        group_module("shared uint one;\n", "if (at == 0u) one = 0u; barrier(); put(atomicAdd(one, 1u));\n");
    EXPECT_NE(in_group<float>(module, 4), in_group<float>(module, 4, Order::backward));
    const auto outcome =
        numeric::Paths::explore(numeric::float32, 4, [&] { (void)in_group<numeric::Interval>(module, 4); });
    EXPECT_EQ(outcome, numeric::Paths::Outcome::undetermined);
}

TEST(Group, SumsOfASubgroupHoldInEveryOrder) {
    const module::Spirv module = group_module("", "put(floatBitsToUint(subgroupAdd(1.0 / float(x()))));\n");
    const float got = std::bit_cast<float>(group_on_device(module).front());
    const Word size = test::SharedDevice::get()->info().subgroup_size;
    numeric::Bounds bounds{};
    numeric::Paths::explore(numeric::float32, 4, [&] {
        bounds = values_in_group<numeric::Interval>(module, size)[0].number().bounds();
    });
    EXPECT_TRUE(bounds.contains(static_cast<double>(got)));
    EXPECT_LT(bounds.high - bounds.low, 1e-5);
    EXPECT_GT(bounds.high - bounds.low, 0.0);
}

TEST(Group, AnInvocationAloneHasNoNeighbours) {
    const Program program(group_module("", "put(subgroupAdd(x()));\n"));
    Machine<float> machine(program);
    const std::vector<Word> words(lanes, 1U);
    machine.bind(0, 0, words);
    machine.bind(0, 1, words);
    machine.set_invocation({});
    expect_error<Error>([&] { machine.run(); }, {"several invocations"});
    EXPECT_THROW(machine.set_group({.group_size = {64, 64, 1}}), Error);
}

}  // namespace gloam::group_test
