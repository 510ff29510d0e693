// SPDX-License-Identifier: MIT
#include "interpreter/internal/operations.hpp"

#include <fmt/format.h>

namespace gloam::interpreter::internal {
namespace {

// Those that are lowered to other operations, or unknown.
const std::map<std::uint16_t, const char*>& other_names() {
    static const std::map<std::uint16_t, const char*> names{
        {SpvOpTranspose, "OpTranspose"},
        {SpvOpImageSparseFetch, "OpImageSparseFetch"},
        {SpvOpImageSparseRead, "OpImageSparseRead"},
        {SpvOpImageQueryLod, "OpImageQueryLod (textureQueryLod)"},
        {SpvOpImageQuerySamples, "OpImageQuerySamples (textureSamples)"},
        {SpvOpAtomicCompareExchangeWeak, "OpAtomicCompareExchangeWeak"},
        {SpvOpAtomicFlagTestAndSet, "OpAtomicFlagTestAndSet"},
        {SpvOpAtomicFlagClear, "OpAtomicFlagClear"},
        {SpvOpEmitVertex, "OpEmitVertex"},
        {SpvOpEndPrimitive, "OpEndPrimitive"},
        {SpvOpReadClockKHR, "OpReadClockKHR (clockARB, clockRealtimeEXT)"},
        {SpvOpTraceRayKHR, "OpTraceRayKHR"},
        {SpvOpRayQueryInitializeKHR, "OpRayQueryInitializeKHR"},
        {SpvOpDemoteToHelperInvocation, "OpDemoteToHelperInvocation (demote)"},
        {SpvOpIsHelperInvocationEXT, "OpIsHelperInvocationEXT (helperInvocationEXT)"},
        {image_sample, "OpImageSample"}};
    return names;
}

}  // namespace

const Known* known_operation(std::uint16_t opcode) {
    const auto found = operations<float>().find(opcode);
    return found == operations<float>().end() ? nullptr : &found->second.known;
}

std::string name_of(std::uint16_t opcode) {
    if (const Known* known = known_operation(opcode)) return known->name;
    if (const auto other = other_names().find(opcode); other != other_names().end()) return other->second;
    if (opcode >= extended && opcode < copy)
        return fmt::format("GLSL.std.450 instruction {}", opcode - extended);
    return fmt::format("opcode {}", opcode);
}

std::uint32_t results_of(const Instruction& instruction) {
    const std::uint16_t op = instruction.op;
    if (op == SpvOpVectorTimesMatrix) return instruction.c;
    if (op == SpvOpMatrixTimesVector || op == SpvOpMatrixTimesMatrix || op == SpvOpOuterProduct)
        return instruction.count * instruction.c;
    const Known* known = known_operation(instruction.op);
    if (known != nullptr && known->gives_one()) return 1;
    return known != nullptr && known->form == Form::pair ? 2 * instruction.count : instruction.count;
}

std::string where_text(const Location& place) {
    return place.line == 0 && place.function.empty() ? "" : " at " + to_text(place);
}

std::string cause_of(const Code& code, const Instruction& instruction) {
    constexpr const char* shift = "a shift by less than 0 or by more than 31";
    constexpr const char* field = "bits outside the 32 of a word";
    constexpr const char* clamp = "clamp() with its lower end above the upper one";
    static const std::map<std::uint16_t, const char*> causes{
        {SpvOpUDiv, "an integer is divided by 0"},
        {SpvOpSDiv, "an integer is divided by 0, or -2147483648 by -1"},
        {SpvOpUMod, "% by 0"},
        {SpvOpSRem, "% by 0, or of a negative number"},
        {SpvOpSMod, "% by 0, or of a negative number"},
        {SpvOpShiftLeftLogical, shift},
        {SpvOpShiftRightLogical, shift},
        {SpvOpShiftRightArithmetic, shift},
        {SpvOpBitFieldInsert, field},
        {SpvOpBitFieldSExtract, field},
        {SpvOpBitFieldUExtract, field},
        {SpvOpConvertFToS, "int() of NaN or of a number beyond an int"},
        {SpvOpConvertFToU, "uint() of NaN, of a negative number or of one beyond a uint"},
        {extended + GLSLstd450FClamp, clamp},
        {extended + GLSLstd450UClamp, clamp},
        {extended + GLSLstd450SClamp, clamp},
        {extended + GLSLstd450NClamp, clamp},
        {extended + GLSLstd450Ldexp, "ldexp() with an exponent or a product beyond the type"}};
    if (instruction.op == undefine) {
        const std::string& name = code.variables.at(instruction.extra);
        return name.empty() ? "a value was never written or returned"
                            : fmt::format("\"{}\" was never written", name);
    }
    const auto cause = causes.find(instruction.op);
    return cause == causes.end() ? name_of(instruction.op) + " has no defined result" : cause->second;
}

bool writes_through_pointer(std::uint16_t opcode) {
    return opcode == extended + GLSLstd450Modf || opcode == extended + GLSLstd450Frexp;
}

}  // namespace gloam::interpreter::internal
