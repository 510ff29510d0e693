// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "interpreter/internal/control.hpp"
#include "interpreter/internal/vectors.hpp"

// What every instruction does.
namespace gloam::interpreter::internal {

// An operation on numbers.
template <class N>
struct Row {
    Known known;
    Handler<N> handler;
};

// clang-format off
#define GLOAM_OP(name, arity, form, ...) {SpvOp##name, {{arity, "Op" #name, Form::form}, __VA_ARGS__}}
#define GLOAM_GLSL(name, arity, form, ...) \
    {extended + GLSLstd450##name, {{arity, "GLSL.std.450 " #name, Form::form}, __VA_ARGS__}}

// A row each: its name, its operands, its form and its handler.
template <class N>
[[nodiscard]] const std::map<std::uint16_t, Row<N>>& operations() {
    static const std::map<std::uint16_t, Row<N>> all{
        GLOAM_OP(FNegate, 1, arithmetic, unary<N, Negate>),
        GLOAM_OP(FAdd, 2, arithmetic, binary<N, Add>),
        GLOAM_OP(FSub, 2, arithmetic, binary<N, Subtract>),
        GLOAM_OP(FMul, 2, arithmetic, binary<N, Multiply>),
        GLOAM_OP(FDiv, 2, arithmetic, binary<N, Divide>),
        GLOAM_OP(FRem, 2, arithmetic, binary<N, Remainder>),
        GLOAM_OP(FMod, 2, arithmetic, binary<N, Mod>),
        GLOAM_OP(VectorTimesScalar, 2, arithmetic, binary<N, Multiply>),
        GLOAM_OP(MatrixTimesScalar, 2, arithmetic, binary<N, Multiply>),
        GLOAM_OP(VectorTimesMatrix, 2, plain, vector_times_matrix<N>),
        GLOAM_OP(MatrixTimesVector, 2, plain, matrix_times_matrix<N>),
        GLOAM_OP(MatrixTimesMatrix, 2, plain, matrix_times_matrix<N>),
        GLOAM_OP(OuterProduct, 2, plain, outer_product<N>),
        GLOAM_OP(Dot, 2, plain, dot_product<N>),
        GLOAM_OP(SNegate, 1, plain, on_one<N, ([](Word x) { return Word{0} - x; })>),
        GLOAM_OP(IAdd, 2, plain, on_two<N, ([](Word x, Word y) { return x + y; })>),
        GLOAM_OP(ISub, 2, plain, on_two<N, ([](Word x, Word y) { return x - y; })>),
        GLOAM_OP(IMul, 2, plain, on_two<N, ([](Word x, Word y) { return x * y; })>),
        GLOAM_OP(UDiv, 2, plain, on_two_if<N,
            ([](Word x, Word y) { return y == 0 ? ~Word{0} : x / y; }), divides>),
        GLOAM_OP(SDiv, 2, plain, on_two_if<N, signed_quotient, signed_divides>),
        GLOAM_OP(UMod, 2, plain, on_two_if<N,
            ([](Word x, Word y) { return y == 0 ? ~Word{0} : x % y; }), divides>),
        GLOAM_OP(SRem, 2, plain, on_two_if<N, signed_remainder, signed_leaves>),
        GLOAM_OP(SMod, 2, plain, on_two_if<N, signed_modulo, signed_leaves>),
        GLOAM_OP(IAddCarry, 2, pair, to_two<N, ([](Word x, Word y) { return std::uint64_t{x} + y; })>),
        GLOAM_OP(ISubBorrow, 2, pair, to_two<N,
            ([](Word x, Word y) { return std::uint64_t{x - y} | (x < y ? 1ULL << word_bits : 0ULL); })>),
        GLOAM_OP(UMulExtended, 2, pair, to_two<N, ([](Word x, Word y) { return std::uint64_t{x} * y; })>),
        GLOAM_OP(SMulExtended, 2, pair, to_two<N,
            ([](Word x, Word y) { return std::uint64_t(std::int64_t{as_int(x)} * as_int(y)); })>),
        GLOAM_OP(Any, 1, to_one_truth, reduce<N, false>),
        GLOAM_OP(All, 1, to_one_truth, reduce<N, true>),
        GLOAM_OP(IsNan, 1, truth, unary<N, IsNan>),
        GLOAM_OP(IsInf, 1, truth, unary<N, IsInfinite>),
        GLOAM_OP(LogicalEqual, 2, truth, on_two<N, ([](Word x, Word y) { return (x != 0) == (y != 0); })>),
        GLOAM_OP(LogicalNotEqual, 2, truth, on_two<N, ([](Word x, Word y) { return (x != 0) != (y != 0); })>),
        GLOAM_OP(LogicalOr, 2, truth, on_two<N, ([](Word x, Word y) { return x != 0 || y != 0; })>),
        GLOAM_OP(LogicalAnd, 2, truth, on_two<N, ([](Word x, Word y) { return x != 0 && y != 0; })>),
        GLOAM_OP(LogicalNot, 1, truth, on_one<N, ([](Word x) { return x == 0 ? 1U : 0U; })>),
        GLOAM_OP(IEqual, 2, truth, compare_words<N, true>),
        GLOAM_OP(INotEqual, 2, truth, compare_words<N, false>),
        GLOAM_OP(UGreaterThan, 2, truth, compare<N, ([](Word x, Word y) { return x > y; })>),
        GLOAM_OP(SGreaterThan, 2, truth, compare<N, ([](Word x, Word y) { return as_int(x) > as_int(y); })>),
        GLOAM_OP(UGreaterThanEqual, 2, truth, compare<N, ([](Word x, Word y) { return x >= y; })>),
        GLOAM_OP(SGreaterThanEqual, 2, truth, compare<N,
            ([](Word x, Word y) { return as_int(x) >= as_int(y); })>),
        GLOAM_OP(ULessThan, 2, truth, compare<N, ([](Word x, Word y) { return x < y; })>),
        GLOAM_OP(SLessThan, 2, truth, compare<N, ([](Word x, Word y) { return as_int(x) < as_int(y); })>),
        GLOAM_OP(ULessThanEqual, 2, truth, compare<N, ([](Word x, Word y) { return x <= y; })>),
        GLOAM_OP(SLessThanEqual, 2, truth, compare<N,
            ([](Word x, Word y) { return as_int(x) <= as_int(y); })>),
        GLOAM_OP(FOrdEqual, 2, truth, binary<N, Equal>),
        GLOAM_OP(FUnordEqual, 2, truth, binary<N, Reversed<Either<Less, Exchanged<Less>>>>),
        GLOAM_OP(FOrdNotEqual, 2, truth, binary<N, Either<Less, Exchanged<Less>>>),
        GLOAM_OP(FUnordNotEqual, 2, truth, binary<N, Reversed<Equal>>),
        GLOAM_OP(FOrdLessThan, 2, truth, binary<N, Less>),
        GLOAM_OP(FUnordLessThan, 2, truth, binary<N, Reversed<Exchanged<LessEqual>>>),
        GLOAM_OP(FOrdGreaterThan, 2, truth, binary<N, Exchanged<Less>>),
        GLOAM_OP(FUnordGreaterThan, 2, truth, binary<N, Reversed<LessEqual>>),
        GLOAM_OP(FOrdLessThanEqual, 2, truth, binary<N, LessEqual>),
        GLOAM_OP(FUnordLessThanEqual, 2, truth, binary<N, Reversed<Exchanged<Less>>>),
        GLOAM_OP(FOrdGreaterThanEqual, 2, truth, binary<N, Exchanged<LessEqual>>),
        GLOAM_OP(FUnordGreaterThanEqual, 2, truth, binary<N, Reversed<Less>>),
        GLOAM_OP(ShiftRightLogical, 2, plain, shift_right<N>),
        GLOAM_OP(ShiftRightArithmetic, 2, plain, on_two_if<N,
            ([](Word x, Word y) { return as_int(x) >> (y < word_bits ? y : word_bits - 1U); }), shifts>),
        GLOAM_OP(ShiftLeftLogical, 2, plain, on_two_if<N,
            ([](Word x, Word y) { return y < word_bits ? x << y : Word{0}; }), shifts>),
        GLOAM_OP(BitwiseOr, 2, plain, on_two<N, ([](Word x, Word y) { return x | y; })>),
        GLOAM_OP(BitwiseXor, 2, plain, on_two<N, ([](Word x, Word y) { return x ^ y; })>),
        GLOAM_OP(BitwiseAnd, 2, plain, bitwise_and<N>),
        GLOAM_OP(Not, 1, plain, on_one<N, ([](Word x) { return ~x; })>),
        GLOAM_OP(BitFieldInsert, 4, plain, bit_field_insert<N>),
        GLOAM_OP(BitFieldSExtract, 3, plain, bit_field_extract<N, true>),
        GLOAM_OP(BitFieldUExtract, 3, plain, bit_field_extract<N, false>),
        GLOAM_OP(BitReverse, 1, plain, on_one<N, reversed>),
        GLOAM_OP(BitCount, 1, plain, on_one<N, ([](Word x) { return std::popcount(x); })>),
        GLOAM_OP(ConvertFToU, 1, plain, convert_to_integer<N, Word>),
        GLOAM_OP(ConvertFToS, 1, plain, convert_to_integer<N, std::int32_t>),
        GLOAM_OP(ConvertSToF, 1, plain, convert_integer<N, std::int32_t>),
        GLOAM_OP(ConvertUToF, 1, plain, convert_integer<N, Word>),
        GLOAM_OP(FConvert, 1, plain, convert_float<N>),
        GLOAM_OP(QuantizeToF16, 1, plain, unary<N, QuantizeToHalf>),
        GLOAM_GLSL(Round, 1, plain, unary<N, Round>),
        GLOAM_GLSL(RoundEven, 1, plain, unary<N, RoundEven>),
        GLOAM_GLSL(Trunc, 1, plain, unary<N, Trunc>),
        GLOAM_GLSL(FAbs, 1, plain, unary<N, Abs>),
        GLOAM_GLSL(SAbs, 1, plain, on_one<N, ([](Word x) { return as_int(x) < 0 ? Word{0} - x : x; })>),
        GLOAM_GLSL(FSign, 1, plain, unary<N, Sign>),
        GLOAM_GLSL(SSign, 1, plain, on_one<N, ([](Word x) { return (as_int(x) > 0) - (as_int(x) < 0); })>),
        GLOAM_GLSL(Floor, 1, plain, unary<N, Floor>),
        GLOAM_GLSL(Ceil, 1, plain, unary<N, Ceil>),
        GLOAM_GLSL(Fract, 1, plain, unary<N, Fract>),
        GLOAM_GLSL(Radians, 1, plain, unary<N, Radians>),
        GLOAM_GLSL(Degrees, 1, plain, unary<N, Degrees>),
        GLOAM_GLSL(Sin, 1, plain, unary<N, Sin>),
        GLOAM_GLSL(Cos, 1, plain, unary<N, Cos>),
        GLOAM_GLSL(Tan, 1, plain, unary<N, Tan>),
        GLOAM_GLSL(Asin, 1, plain, unary<N, Asin>),
        GLOAM_GLSL(Acos, 1, plain, unary<N, Acos>),
        GLOAM_GLSL(Atan, 1, plain, unary<N, Atan>),
        GLOAM_GLSL(Sinh, 1, plain, unary<N, Sinh>),
        GLOAM_GLSL(Cosh, 1, plain, unary<N, Cosh>),
        GLOAM_GLSL(Tanh, 1, plain, unary<N, Tanh>),
        GLOAM_GLSL(Asinh, 1, plain, unary<N, Asinh>),
        GLOAM_GLSL(Acosh, 1, plain, unary<N, Acosh>),
        GLOAM_GLSL(Atanh, 1, plain, unary<N, Atanh>),
        GLOAM_GLSL(Atan2, 2, plain, binary<N, Atan2>),
        GLOAM_GLSL(Pow, 2, plain, binary<N, Pow>),
        GLOAM_GLSL(Exp, 1, plain, unary<N, Exp>),
        GLOAM_GLSL(Log, 1, plain, unary<N, Log>),
        GLOAM_GLSL(Exp2, 1, plain, unary<N, Exp2>),
        GLOAM_GLSL(Log2, 1, plain, unary<N, Log2>),
        GLOAM_GLSL(Sqrt, 1, plain, unary<N, Sqrt>),
        GLOAM_GLSL(InverseSqrt, 1, plain, unary<N, InverseSqrt>),
        GLOAM_GLSL(Determinant, 1, to_one,
            [](State<N>& s, const Instruction& i) { of_matrix(s, i, false); }),
        GLOAM_GLSL(MatrixInverse, 1, at_once,
            [](State<N>& s, const Instruction& i) { of_matrix(s, i, true); }),
        GLOAM_GLSL(Modf, 2, pair, modf<N>),
        GLOAM_GLSL(ModfStruct, 1, pair, modf<N>),
        GLOAM_GLSL(FMin, 2, plain, binary<N, Min>),
        GLOAM_GLSL(UMin, 2, plain, on_two<N, ([](Word x, Word y) { return std::min(x, y); })>),
        GLOAM_GLSL(SMin, 2, plain, on_two<N,
            ([](Word x, Word y) { return std::min(as_int(x), as_int(y)); })>),
        GLOAM_GLSL(FMax, 2, plain, binary<N, Max>),
        GLOAM_GLSL(UMax, 2, plain, on_two<N, ([](Word x, Word y) { return std::max(x, y); })>),
        GLOAM_GLSL(SMax, 2, plain, on_two<N,
            ([](Word x, Word y) { return std::max(as_int(x), as_int(y)); })>),
        GLOAM_GLSL(FClamp, 3, plain, clamp_float<N>),
        GLOAM_GLSL(UClamp, 3, plain, clamp_integer<N, Word>),
        GLOAM_GLSL(SClamp, 3, plain, clamp_integer<N, std::int32_t>),
        GLOAM_GLSL(FMix, 3, plain, ternary<N, Mix>),
        GLOAM_GLSL(Step, 2, plain, binary<N, StepAt>),
        GLOAM_GLSL(SmoothStep, 3, plain, ternary<N, SmoothStep>),
        GLOAM_GLSL(Fma, 3, plain, ternary<N, Fma>),
        GLOAM_GLSL(Frexp, 2, pair, frexp<N>),
        GLOAM_GLSL(FrexpStruct, 1, pair, frexp<N>),
        GLOAM_GLSL(Ldexp, 2, plain, load_exponent<N>),
        GLOAM_GLSL(PackSnorm4x8, 1, plain, pack<N, 4, true>),
        GLOAM_GLSL(PackUnorm4x8, 1, plain, pack<N, 4, false>),
        GLOAM_GLSL(PackSnorm2x16, 1, plain, pack<N, 2, true>),
        GLOAM_GLSL(PackUnorm2x16, 1, plain, pack<N, 2, false>),
        GLOAM_GLSL(PackHalf2x16, 1, plain, pack_half<N>),
        GLOAM_GLSL(UnpackSnorm2x16, 1, plain, unpack<N, 2, true>),
        GLOAM_GLSL(UnpackUnorm2x16, 1, plain, unpack<N, 2, false>),
        GLOAM_GLSL(UnpackHalf2x16, 1, plain, unpack_half<N>),
        GLOAM_GLSL(UnpackSnorm4x8, 1, plain, unpack<N, 4, true>),
        GLOAM_GLSL(UnpackUnorm4x8, 1, plain, unpack<N, 4, false>),
        GLOAM_GLSL(Length, 1, to_one, length<N>),
        GLOAM_GLSL(Distance, 2, to_one, distance<N>),
        GLOAM_GLSL(Cross, 2, plain, cross<N>),
        GLOAM_GLSL(Normalize, 1, at_once, normalize<N>),
        GLOAM_GLSL(FaceForward, 3, at_once, face_forward<N>),
        GLOAM_GLSL(Reflect, 2, at_once, reflect<N>),
        GLOAM_GLSL(Refract, 3, at_once, refract<N>),
        GLOAM_GLSL(FindILsb, 1, plain, on_one<N,
            ([](Word x) { return x == 0 ? ~0U : static_cast<Word>(std::countr_zero(x)); })>),
        GLOAM_GLSL(FindSMsb, 1, plain, on_one<N,
            ([](Word x) { return highest_bit(as_int(x) < 0 ? ~x : x); })>),
        GLOAM_GLSL(FindUMsb, 1, plain, on_one<N, highest_bit>),
        GLOAM_GLSL(NMin, 2, plain, binary<N, Min>),
        GLOAM_GLSL(NMax, 2, plain, binary<N, Max>),
        GLOAM_GLSL(NClamp, 3, plain, clamp_float<N>),
    };
    return all;
}

#undef GLOAM_OP
#undef GLOAM_GLSL

// The handler of an instruction; null for an unknown one.
template <class N>
[[nodiscard]] Handler<N> handler_of(const Instruction& instruction) {
    // The group goes on where all that it waits for have come (internal/group.hpp).
    constexpr Handler<N> wait = [](State<N>& s, const Instruction&) { s.running = false, s.waits = true; };
    static const std::map<std::uint16_t, Handler<N>> others{
        {copy, [](State<N>& s, const Instruction& i) { copy_slots(s, i, i.a); }},
        {pack_halves, do_pack_halves<N>},
        {unpack_halves, do_unpack_halves<N>},
        {to_float, do_to_float<N>},
        {gather, do_gather<N>},
        {undefine, do_undefine<N>},
        {select, do_select<N>},
        {extract_dynamic, do_extract<N>},
        {insert_dynamic, do_insert<N>},
        {jump, [](State<N>& s, const Instruction& i) { follow(s, i.extra); }},
        {branch, [](State<N>& s, const Instruction& i) {
             follow(s, s.known_bits(i.a) != 0 ? i.extra : i.b);
         }},
        {switch_on, do_switch<N>},
        {finish, [](State<N>& s, const Instruction&) { s.running = false; }},
        {unreachable, [](State<N>&, const Instruction&) {
             throw Fault{Error::Kind::malformed, "an unreachable block was reached"};
         }},
        {chain, do_chain<N>},
        {load_slots, [](State<N>& s, const Instruction& i) { copy_slots(s, i, s.pointers[i.a].offset); }},
        {store_slots, [](State<N>& s, const Instruction& i) {
             std::copy_n(s.slots.begin() + i.b, i.count, s.slots.begin() + s.pointers[i.a].offset);
         }},
        {load_memory, do_load_memory<N>},
        {store_memory, do_store_memory<N>},
        {array_length, do_array_length<N>},
        {load_resource, [](State<N>& s, const Instruction& i) {
             s.set(i, i.result, s.pointers[i.a].resource);
         }},
        {image_load, do_image_load<N>},
        {image_store, do_image_store<N>},
        {image_size, do_image_size<N>},
        {image_sample, do_image_sample<N>},
        {image_levels, do_image_levels<N>},
        {image_texel, do_image_texel<N>},
        {atomic, do_atomic<N>},
        {fence, [](State<N>& s, const Instruction& i) { s.fenced |= i.c; }},
        {construct, do_construct<N>},
        {barrier, wait},
        {neighbour, wait},
        {collective, wait},
        {either, do_either<N>},
    };
    // clang-format on
    if (instruction.op == copy && instruction.count == 1 && (instruction.flags & flags::relaxed) == 0)
        return [](State<N>& s, const Instruction& i) { s.slots[i.result] = s.slots[i.a]; };
    if (const auto other = others.find(instruction.op); other != others.end()) return other->second;
    const auto found = operations<N>().find(instruction.op);
    return found == operations<N>().end() ? nullptr : found->second.handler;
}

}  // namespace gloam::interpreter::internal
