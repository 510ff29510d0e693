// SPDX-License-Identifier: MIT
// Operations on a subgroup.
#include <fmt/format.h>

#include <map>

#include "shader/internal/wgsl/function_writer.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

// The name in WGSL behind "subgroup", by the instruction of SPIR-V.
const std::map<std::uint32_t, const char*>& plain_names() {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpGroupNonUniformElect, "subgroupElect"},
        {SpvOpGroupNonUniformAll, "subgroupAll"},
        {SpvOpGroupNonUniformAny, "subgroupAny"},
        {SpvOpGroupNonUniformBroadcast, "subgroupBroadcast"},
        {SpvOpGroupNonUniformBroadcastFirst, "subgroupBroadcastFirst"},
        {SpvOpGroupNonUniformBallot, "subgroupBallot"},
        {SpvOpGroupNonUniformShuffle, "subgroupShuffle"},
        {SpvOpGroupNonUniformShuffleXor, "subgroupShuffleXor"},
        {SpvOpGroupNonUniformShuffleUp, "subgroupShuffleUp"},
        {SpvOpGroupNonUniformShuffleDown, "subgroupShuffleDown"},
        {SpvOpGroupNonUniformQuadBroadcast, "quadBroadcast"}};
    return names;
}

const std::map<std::uint32_t, const char*>& sum_names() {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpGroupNonUniformIAdd, "Add"},       {SpvOpGroupNonUniformFAdd, "Add"},
        {SpvOpGroupNonUniformIMul, "Mul"},       {SpvOpGroupNonUniformFMul, "Mul"},
        {SpvOpGroupNonUniformSMin, "Min"},       {SpvOpGroupNonUniformUMin, "Min"},
        {SpvOpGroupNonUniformFMin, "Min"},       {SpvOpGroupNonUniformSMax, "Max"},
        {SpvOpGroupNonUniformUMax, "Max"},       {SpvOpGroupNonUniformFMax, "Max"},
        {SpvOpGroupNonUniformBitwiseAnd, "And"}, {SpvOpGroupNonUniformBitwiseOr, "Or"},
        {SpvOpGroupNonUniformBitwiseXor, "Xor"}};
    return names;
}

// The function of a sum over the whole subgroup, or over the invocations before this one.
std::string sum_name(const std::string& name, std::uint32_t operation) {
    if (operation == SpvGroupOperationReduce) return "subgroup" + name;
    if (name != "Add" && name != "Mul")
        throw WgslError("a minimum, maximum or bit operation over the invocations before this one");
    if (operation == SpvGroupOperationInclusiveScan) return "subgroupInclusive" + name;
    if (operation == SpvGroupOperationExclusiveScan) return "subgroupExclusive" + name;
    throw WgslError("a subgroup operation over clusters");
}

std::string quad_swap(const Module& module, Id direction) {
    constexpr const char* names[] = {"quadSwapX", "quadSwapY", "quadSwapDiagonal"};
    return names[module.integer(direction).value_or(0) % 3];
}

}  // namespace

bool is_subgroup_operation(std::uint32_t opcode) {
    return opcode >= SpvOpGroupNonUniformElect && opcode <= SpvOpGroupNonUniformQuadSwap;
}

// Evaluated where it stands: its result depends on the invocations that run there.
bool FunctionWriter::subgroup_operation(const Instruction& i, Statements& out) {
    if (!is_subgroup_operation(i.opcode)) return false;
    if (shape_.uses[i.word(2)] == 0) return true;
    std::vector<Expression> arguments = take_all(i);
    std::string name;
    if (const auto plain_name = plain_names().find(i.opcode); plain_name != plain_names().end()) {
        name = plain_name->second;
    } else if (const auto sum = sum_names().find(i.opcode); sum != sum_names().end()) {
        name = sum_name(sum->second, i.word(4));
    } else if (i.opcode == SpvOpGroupNonUniformQuadSwap) {
        name = quad_swap(module_, i.word(5));
        arguments.resize(1);
    } else {
        throw NotTranslated(fmt::format("the subgroup instruction {} of SPIR-V", i.opcode));
    }
    text_.need_extension("subgroups");
    keep(i.word(2), call(name, arguments), out);
    return true;
}

}  // namespace gloam::shader::internal::wgsl
