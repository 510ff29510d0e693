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
    switch (instruction.op) {
        case SpvOpVectorTimesMatrix:
            return instruction.c;
        case SpvOpMatrixTimesVector:
        case SpvOpMatrixTimesMatrix:
        case SpvOpOuterProduct:
            return instruction.count * instruction.c;
        default:
            break;
    }
    const Known* known = known_operation(instruction.op);
    if (known != nullptr && known->gives_one()) return 1;
    return known != nullptr && known->form == Form::pair ? 2 * instruction.count : instruction.count;
}

std::string where_text(const Place& place) {
    return place.line == 0 && place.function.empty() ? "" : " at " + to_text(place);
}

std::string cause_of(const Code& code, const Instruction& instruction) {
    switch (instruction.op) {
        case undefine: {
            const std::string& name = code.variables.at(instruction.extra);
            return name.empty() ? "a value was never written or returned"
                                : fmt::format("\"{}\" was never written", name);
        }
        case SpvOpUDiv:
            return "an integer is divided by 0";
        case SpvOpSDiv:
            return "an integer is divided by 0, or -2147483648 by -1";
        case SpvOpUMod:
            return "% by 0";
        case SpvOpSRem:
        case SpvOpSMod:
            return "% by 0, or of a negative number";
        case SpvOpShiftLeftLogical:
        case SpvOpShiftRightLogical:
        case SpvOpShiftRightArithmetic:
            return "a shift by less than 0 or by more than 31";
        case SpvOpBitFieldInsert:
        case SpvOpBitFieldSExtract:
        case SpvOpBitFieldUExtract:
            return "bits outside the 32 of a word";
        case SpvOpConvertFToS:
            return "int() of NaN or of a number beyond an int";
        case SpvOpConvertFToU:
            return "uint() of NaN, of a negative number or of one beyond a uint";
        case extended + GLSLstd450FClamp:
        case extended + GLSLstd450UClamp:
        case extended + GLSLstd450SClamp:
        case extended + GLSLstd450NClamp:
            return "clamp() with its lower end above the upper one";
        case extended + GLSLstd450Ldexp:
            return "ldexp() with an exponent or a product beyond the type";
        default:
            return name_of(instruction.op) + " has no defined result";
    }
}

bool writes_through_pointer(std::uint16_t opcode) {
    return opcode == extended + GLSLstd450Modf || opcode == extended + GLSLstd450Frexp;
}

}  // namespace gloam::interpreter::internal
