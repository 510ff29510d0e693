// SPDX-License-Identifier: MIT
#include "interpreter/internal/code.hpp"

#include <fmt/format.h>
#include "interpreter/internal/opcodes.hpp"
#include "interpreter/internal/state.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace gloam::interpreter::internal {
namespace {

struct Known {
    std::uint8_t arity;
    const char* name;
};

using Table = std::map<std::uint16_t, Known>;

#define GLOAM_OP(name, arity)                      \
    {                                              \
        static_cast<std::uint16_t>(SpvOp##name), { \
            arity, "Op" #name                      \
        }                                          \
    }
#define GLOAM_EXTENDED(name, arity)                                \
    {                                                              \
        static_cast<std::uint16_t>(extended + GLSLstd450##name), { \
            arity, "GLSL.std.450 " #name                           \
        }                                                          \
    }

const Table& table() {
    static const Table known{GLOAM_OP(FNegate, 1),
                             GLOAM_OP(FAdd, 2),
                             GLOAM_OP(FSub, 2),
                             GLOAM_OP(FMul, 2),
                             GLOAM_OP(FDiv, 2),
                             GLOAM_OP(FRem, 2),
                             GLOAM_OP(FMod, 2),
                             GLOAM_OP(VectorTimesScalar, 2),
                             GLOAM_OP(MatrixTimesScalar, 2),
                             GLOAM_OP(Dot, 2),
                             GLOAM_OP(SNegate, 1),
                             GLOAM_OP(IAdd, 2),
                             GLOAM_OP(ISub, 2),
                             GLOAM_OP(IMul, 2),
                             GLOAM_OP(UDiv, 2),
                             GLOAM_OP(SDiv, 2),
                             GLOAM_OP(UMod, 2),
                             GLOAM_OP(SRem, 2),
                             GLOAM_OP(SMod, 2),
                             GLOAM_OP(IAddCarry, 2),
                             GLOAM_OP(ISubBorrow, 2),
                             GLOAM_OP(UMulExtended, 2),
                             GLOAM_OP(SMulExtended, 2),
                             GLOAM_OP(Any, 1),
                             GLOAM_OP(All, 1),
                             GLOAM_OP(IsNan, 1),
                             GLOAM_OP(IsInf, 1),
                             GLOAM_OP(LogicalEqual, 2),
                             GLOAM_OP(LogicalNotEqual, 2),
                             GLOAM_OP(LogicalOr, 2),
                             GLOAM_OP(LogicalAnd, 2),
                             GLOAM_OP(LogicalNot, 1),
                             GLOAM_OP(IEqual, 2),
                             GLOAM_OP(INotEqual, 2),
                             GLOAM_OP(UGreaterThan, 2),
                             GLOAM_OP(SGreaterThan, 2),
                             GLOAM_OP(UGreaterThanEqual, 2),
                             GLOAM_OP(SGreaterThanEqual, 2),
                             GLOAM_OP(ULessThan, 2),
                             GLOAM_OP(SLessThan, 2),
                             GLOAM_OP(ULessThanEqual, 2),
                             GLOAM_OP(SLessThanEqual, 2),
                             GLOAM_OP(FOrdEqual, 2),
                             GLOAM_OP(FUnordEqual, 2),
                             GLOAM_OP(FOrdNotEqual, 2),
                             GLOAM_OP(FUnordNotEqual, 2),
                             GLOAM_OP(FOrdLessThan, 2),
                             GLOAM_OP(FUnordLessThan, 2),
                             GLOAM_OP(FOrdGreaterThan, 2),
                             GLOAM_OP(FUnordGreaterThan, 2),
                             GLOAM_OP(FOrdLessThanEqual, 2),
                             GLOAM_OP(FUnordLessThanEqual, 2),
                             GLOAM_OP(FOrdGreaterThanEqual, 2),
                             GLOAM_OP(FUnordGreaterThanEqual, 2),
                             GLOAM_OP(ShiftRightLogical, 2),
                             GLOAM_OP(ShiftRightArithmetic, 2),
                             GLOAM_OP(ShiftLeftLogical, 2),
                             GLOAM_OP(BitwiseOr, 2),
                             GLOAM_OP(BitwiseXor, 2),
                             GLOAM_OP(BitwiseAnd, 2),
                             GLOAM_OP(Not, 1),
                             GLOAM_OP(BitFieldInsert, 4),
                             GLOAM_OP(BitFieldSExtract, 3),
                             GLOAM_OP(BitFieldUExtract, 3),
                             GLOAM_OP(BitReverse, 1),
                             GLOAM_OP(BitCount, 1),
                             GLOAM_OP(ConvertFToU, 1),
                             GLOAM_OP(ConvertFToS, 1),
                             GLOAM_OP(ConvertSToF, 1),
                             GLOAM_OP(ConvertUToF, 1),
                             GLOAM_OP(FConvert, 1),
                             GLOAM_OP(QuantizeToF16, 1),
                             GLOAM_EXTENDED(Round, 1),
                             GLOAM_EXTENDED(RoundEven, 1),
                             GLOAM_EXTENDED(Trunc, 1),
                             GLOAM_EXTENDED(FAbs, 1),
                             GLOAM_EXTENDED(SAbs, 1),
                             GLOAM_EXTENDED(FSign, 1),
                             GLOAM_EXTENDED(SSign, 1),
                             GLOAM_EXTENDED(Floor, 1),
                             GLOAM_EXTENDED(Ceil, 1),
                             GLOAM_EXTENDED(Fract, 1),
                             GLOAM_EXTENDED(Radians, 1),
                             GLOAM_EXTENDED(Degrees, 1),
                             GLOAM_EXTENDED(Sin, 1),
                             GLOAM_EXTENDED(Cos, 1),
                             GLOAM_EXTENDED(Tan, 1),
                             GLOAM_EXTENDED(Asin, 1),
                             GLOAM_EXTENDED(Acos, 1),
                             GLOAM_EXTENDED(Atan, 1),
                             GLOAM_EXTENDED(Sinh, 1),
                             GLOAM_EXTENDED(Cosh, 1),
                             GLOAM_EXTENDED(Tanh, 1),
                             GLOAM_EXTENDED(Asinh, 1),
                             GLOAM_EXTENDED(Acosh, 1),
                             GLOAM_EXTENDED(Atanh, 1),
                             GLOAM_EXTENDED(Atan2, 2),
                             GLOAM_EXTENDED(Pow, 2),
                             GLOAM_EXTENDED(Exp, 1),
                             GLOAM_EXTENDED(Log, 1),
                             GLOAM_EXTENDED(Exp2, 1),
                             GLOAM_EXTENDED(Log2, 1),
                             GLOAM_EXTENDED(Sqrt, 1),
                             GLOAM_EXTENDED(InverseSqrt, 1),
                             GLOAM_EXTENDED(Determinant, 1),
                             GLOAM_EXTENDED(MatrixInverse, 1),
                             GLOAM_EXTENDED(Modf, 2),
                             GLOAM_EXTENDED(ModfStruct, 1),
                             GLOAM_EXTENDED(FMin, 2),
                             GLOAM_EXTENDED(UMin, 2),
                             GLOAM_EXTENDED(SMin, 2),
                             GLOAM_EXTENDED(FMax, 2),
                             GLOAM_EXTENDED(UMax, 2),
                             GLOAM_EXTENDED(SMax, 2),
                             GLOAM_EXTENDED(FClamp, 3),
                             GLOAM_EXTENDED(UClamp, 3),
                             GLOAM_EXTENDED(SClamp, 3),
                             GLOAM_EXTENDED(FMix, 3),
                             GLOAM_EXTENDED(Step, 2),
                             GLOAM_EXTENDED(SmoothStep, 3),
                             GLOAM_EXTENDED(Fma, 3),
                             GLOAM_EXTENDED(Frexp, 2),
                             GLOAM_EXTENDED(FrexpStruct, 1),
                             GLOAM_EXTENDED(Ldexp, 2),
                             GLOAM_EXTENDED(PackSnorm4x8, 1),
                             GLOAM_EXTENDED(PackUnorm4x8, 1),
                             GLOAM_EXTENDED(PackSnorm2x16, 1),
                             GLOAM_EXTENDED(PackUnorm2x16, 1),
                             GLOAM_EXTENDED(PackHalf2x16, 1),
                             GLOAM_EXTENDED(UnpackSnorm2x16, 1),
                             GLOAM_EXTENDED(UnpackUnorm2x16, 1),
                             GLOAM_EXTENDED(UnpackHalf2x16, 1),
                             GLOAM_EXTENDED(UnpackSnorm4x8, 1),
                             GLOAM_EXTENDED(UnpackUnorm4x8, 1),
                             GLOAM_EXTENDED(Length, 1),
                             GLOAM_EXTENDED(Distance, 2),
                             GLOAM_EXTENDED(Cross, 2),
                             GLOAM_EXTENDED(Normalize, 1),
                             GLOAM_EXTENDED(FaceForward, 3),
                             GLOAM_EXTENDED(Reflect, 2),
                             GLOAM_EXTENDED(Refract, 3),
                             GLOAM_EXTENDED(FindILsb, 1),
                             GLOAM_EXTENDED(FindSMsb, 1),
                             GLOAM_EXTENDED(FindUMsb, 1),
                             GLOAM_EXTENDED(NMin, 2),
                             GLOAM_EXTENDED(NMax, 2),
                             GLOAM_EXTENDED(NClamp, 3)};
    return known;
}

// Those that are lowered to other operations, or unknown.
const std::map<std::uint16_t, const char*>& other_names() {
    static const std::map<std::uint16_t, const char*> names{
        {SpvOpVectorTimesMatrix, "OpVectorTimesMatrix"},
        {SpvOpMatrixTimesVector, "OpMatrixTimesVector"},
        {SpvOpMatrixTimesMatrix, "OpMatrixTimesMatrix"},
        {SpvOpOuterProduct, "OpOuterProduct"},
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
        {SpvOpReadClockKHR, "OpReadClockKHR (clockARB)"},
        {SpvOpTraceRayKHR, "OpTraceRayKHR"},
        {SpvOpRayQueryInitializeKHR, "OpRayQueryInitializeKHR"},
        {SpvOpDemoteToHelperInvocation, "OpDemoteToHelperInvocation (demote)"},
        {SpvOpIsHelperInvocationEXT, "OpIsHelperInvocationEXT (helperInvocationEXT)"},
        {image_sample, "OpImageSample"}};
    return names;
}

#undef GLOAM_OP
#undef GLOAM_EXTENDED

template <std::size_t N>
bool is_one_of(std::uint16_t opcode, const std::array<int, N>& opcodes) {
    return std::ranges::find(opcodes, static_cast<int>(opcode)) != opcodes.end();
}

}  // namespace

std::optional<std::uint8_t> arity_of(std::uint16_t opcode) {
    const auto found = table().find(opcode);
    return found == table().end() ? std::nullopt : std::optional(found->second.arity);
}

std::string name_of(std::uint16_t opcode) {
    const auto found = table().find(opcode);
    if (found != table().end()) return found->second.name;
    if (const auto other = other_names().find(opcode); other != other_names().end()) return other->second;
    if (opcode >= extended && opcode < copy)
        return fmt::format("GLSL.std.450 instruction {}", opcode - extended);
    return fmt::format("opcode {}", opcode);
}

bool takes_count_of_operand(std::uint16_t opcode) {
    return is_one_of(
        opcode, std::array<int, 13>{SpvOpAny, SpvOpAll, SpvOpIAddCarry, SpvOpISubBorrow, SpvOpUMulExtended,
                                    SpvOpSMulExtended, extended + GLSLstd450Length,
                                    extended + GLSLstd450Distance, extended + GLSLstd450Determinant,
                                    extended + GLSLstd450Modf, extended + GLSLstd450ModfStruct,
                                    extended + GLSLstd450Frexp, extended + GLSLstd450FrexpStruct});
}

bool reads_all_first(std::uint16_t opcode) {
    return is_one_of(opcode,
                     std::array<int, 13>{extended + GLSLstd450Normalize, extended + GLSLstd450Reflect,
                                         extended + GLSLstd450Refract, extended + GLSLstd450FaceForward,
                                         extended + GLSLstd450MatrixInverse, extended + GLSLstd450Modf,
                                         extended + GLSLstd450ModfStruct, extended + GLSLstd450Frexp,
                                         extended + GLSLstd450FrexpStruct, SpvOpIAddCarry, SpvOpISubBorrow,
                                         SpvOpUMulExtended, SpvOpSMulExtended});
}

std::uint32_t results_of(const Instruction& instruction) {
    switch (instruction.op) {
        case SpvOpAny:
        case SpvOpAll:
        case extended + GLSLstd450Length:
        case extended + GLSLstd450Distance:
        case extended + GLSLstd450Determinant:
            return 1;
        case SpvOpVectorTimesMatrix:
            return instruction.c;
        case SpvOpMatrixTimesVector:
        case SpvOpMatrixTimesMatrix:
        case SpvOpOuterProduct:
            return instruction.count * instruction.c;
        default:  // a pair: a sum and its carry, ...
            return takes_count_of_operand(instruction.op) ? 2 * instruction.count : instruction.count;
    }
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
        default:
            return name_of(instruction.op) + " has no defined result";
    }
}

bool writes_through_pointer(std::uint16_t opcode) {
    return opcode == extended + GLSLstd450Modf || opcode == extended + GLSLstd450Frexp;
}

bool is_float_arithmetic(std::uint16_t opcode) {
    return is_one_of(opcode,
                     std::array<int, 9>{SpvOpFNegate, SpvOpFAdd, SpvOpFSub, SpvOpFMul, SpvOpFDiv, SpvOpFRem,
                                        SpvOpFMod, SpvOpVectorTimesScalar, SpvOpMatrixTimesScalar});
}

}  // namespace gloam::interpreter::internal
