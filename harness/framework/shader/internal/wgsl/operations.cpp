// SPDX-License-Identifier: MIT
// Arithmetic, logic, conversions and vectors.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

using Operands = std::vector<Expression>;

const std::map<std::uint32_t, const char*>& binary_operators() {
    static const std::map<std::uint32_t, const char*> operators{
        {SpvOpIAdd, "+"},
        {SpvOpFAdd, "+"},
        {SpvOpISub, "-"},
        {SpvOpFSub, "-"},
        {SpvOpIMul, "*"},
        {SpvOpFMul, "*"},
        {SpvOpUDiv, "/"},
        {SpvOpSDiv, "/"},
        {SpvOpFDiv, "/"},
        {SpvOpUMod, "%"},
        {SpvOpSRem, "%"},
        {SpvOpFRem, "%"},
        {SpvOpVectorTimesScalar, "*"},
        {SpvOpMatrixTimesScalar, "*"},
        {SpvOpVectorTimesMatrix, "*"},
        {SpvOpMatrixTimesVector, "*"},
        {SpvOpMatrixTimesMatrix, "*"},
        {SpvOpBitwiseOr, "|"},
        {SpvOpBitwiseXor, "^"},
        {SpvOpBitwiseAnd, "&"},
        {SpvOpLogicalEqual, "=="},
        {SpvOpLogicalNotEqual, "!="},
        {SpvOpIEqual, "=="},
        {SpvOpINotEqual, "!="},
        {SpvOpUGreaterThan, ">"},
        {SpvOpSGreaterThan, ">"},
        {SpvOpUGreaterThanEqual, ">="},
        {SpvOpSGreaterThanEqual, ">="},
        {SpvOpULessThan, "<"},
        {SpvOpSLessThan, "<"},
        {SpvOpULessThanEqual, "<="},
        {SpvOpSLessThanEqual, "<="},
        {SpvOpFOrdEqual, "=="},
        {SpvOpFUnordNotEqual, "!="},
        {SpvOpFOrdLessThan, "<"},
        {SpvOpFOrdGreaterThan, ">"},
        {SpvOpFOrdLessThanEqual, "<="},
        {SpvOpFOrdGreaterThanEqual, ">="},
    };
    return operators;
}

const std::map<std::uint32_t, const char*>& functions() {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpDot, "dot"},
        {SpvOpTranspose, "transpose"},
        {SpvOpAny, "any"},
        {SpvOpAll, "all"},
        {SpvOpBitReverse, "reverseBits"},
        {SpvOpBitCount, "countOneBits"},
        {SpvOpDPdx, "dpdx"},
        {SpvOpDPdy, "dpdy"},
        {SpvOpFwidth, "fwidth"},
    };
    return names;
}

// Opposites of comparisons that are true for NaN.
const std::map<std::uint32_t, const char*>& negated_comparisons() {
    static const std::map<std::uint32_t, const char*> operators{
        {SpvOpFUnordEqual, "!="},        {SpvOpFUnordLessThan, ">="},        {SpvOpFUnordGreaterThan, "<="},
        {SpvOpFUnordLessThanEqual, ">"}, {SpvOpFUnordGreaterThanEqual, "<"}, {SpvOpFOrdNotEqual, "=="}};
    return operators;
}

// WGSL shifts by unsigned numbers alone.
Expression shift(ModuleText& text, const Instruction& i, const Operands& operands, const std::string& sign) {
    const Module& module = text.module();
    const Id by = module.type_of(i.word(4));
    Expression right = operands[1];
    if (module.is_signed(by)) {
        const std::uint32_t n = module.components(by);
        const std::string unsigned_type = n > 1 ? fmt::format("vec{}u", n) : "u32";
        right = right.literal ? plain(right.text + "u") : call(unsigned_type, {right});
    }
    return binary(sign, operands[0].literal ? typed(operands[0]) : operands[0], right);
}

// An unsigned shift to the right of signed numbers.
Expression logical_shift(ModuleText& text, const Instruction& i, const Operands& operands) {
    const Id type = i.word(1);
    if (!text.module().is_signed(type)) return shift(text, i, operands, ">>");
    const std::uint32_t n = text.module().components(type);
    const std::string unsigned_type = n > 1 ? fmt::format("vec{}u", n) : "u32";
    Operands bits = operands;
    bits[0] = call("bitcast<" + unsigned_type + ">", {typed(operands[0])});
    return call("bitcast<" + text.type(type) + ">", {shift(text, i, bits, ">>")});
}

std::string swizzle(const Instruction& i, std::size_t first, std::size_t count, std::uint32_t offset) {
    std::string letters = ".";
    for (std::size_t w = first; w < first + count; ++w) letters += "xyzw"[(i.word(w) - offset) & 3U];
    return letters;
}

// Runs of components of one of the two vectors become parts of a constructor.
Expression shuffle(ModuleText& text, const Instruction& i, const Operands& operands) {
    const Module& module = text.module();
    const std::uint32_t n = module.components(module.type_of(i.word(3)));
    std::vector<Expression> parts;
    for (std::size_t w = 5; w < i.words.size();) {
        const bool second = i.word(w) >= n && i.word(w) != 0xffffffffU;
        std::size_t end = w + 1;
        while (end < i.words.size() && (i.word(end) >= n) == second) ++end;
        const Expression& from = operands[second ? 1 : 0];
        Expression part = plain(primary(from) + swizzle(i, w, end - w, second ? n : 0));
        const Id other = second ? i.word(4) : i.word(3);
        const std::uint32_t all = module.components(module.type_of(other));
        const std::string whole = std::string(".xyzw").substr(0, all + 1);
        if (part.text == primary(from) + whole) part.text = from.text;
        part.reads = from.reads;
        parts.push_back(part);
        w = end;
    }
    return parts.size() == 1 ? parts[0] : call(text.type(i.word(1)), parts);
}

// A bit pattern as another type. Between integers a conversion does; the bits of a float that are a constant
// may be infinity or NaN.
Expression bitcast(ModuleText& text, const Instruction& i, const Expression& value) {
    const Module& module = text.module();
    const Id type = i.word(1);
    const Instruction* constant = module.constant(i.word(3));
    const Id from = module.type_of(i.word(3));
    if (!module.is_float(type) && !module.is_float(from)) return call(text.type(type), {typed(value)});
    if (constant != nullptr && constant->opcode == SpvOpConstant && !module.is_half(type) &&
        !module.is_float(from))
        return call(text.helper("float_of_bits", 0), {typed(value)});
    return call("bitcast<" + text.type(type) + ">", {typed(value)});
}

// `v.x, v.y` as `v.xy`.
Operands joined(const Operands& parts) {
    Operands result;
    for (const Expression& part : parts) {
        const std::size_t dot = part.text.rfind('.');
        const bool follows = part.component && !result.empty() && result.back().component &&
                             result.back().text.substr(0, dot + 1) == part.text.substr(0, dot + 1) &&
                             result.back().text.find_first_not_of("xyzw", dot + 1) == std::string::npos;
        if (follows) {
            result.back().text += part.text.back();
        } else {
            result.push_back(part);
        }
    }
    return result;
}

Expression construct(ModuleText& text, const Instruction& i, Operands operands) {
    const TypeKind kind = text.module().type(i.word(1)).kind;
    const bool equal = std::ranges::all_of(
        operands, [&](const Expression& p) { return p.text == operands[0].text && !p.text.empty(); });
    if (kind == TypeKind::vector && equal && operands.size() == text.module().components(i.word(1)))
        operands.resize(1);
    return call(text.type(i.word(1)), kind == TypeKind::vector ? joined(operands) : operands);
}

Expression extract(ModuleText& text, const Instruction& i, const Expression& from) {
    const Module& module = text.module();
    Id type = module.type_of(i.word(3));
    Expression result = plain(primary(from));
    result.reads = from.reads;
    for (std::size_t w = 4; w < i.words.size(); ++w) {
        const Type& here = module.type(type);
        if (here.kind == TypeKind::structure) {
            result.text += "." + text.member_name(type, i.word(w));
            type = here.members.at(i.word(w)).type;
        } else if (here.kind == TypeKind::vector) {
            result.text += std::string(".") + "xyzw"[i.word(w) & 3U];
            result.component = true;
        } else {
            result.text += fmt::format("[{}]", i.word(w));
            type = here.element;
        }
    }
    return result;
}

Expression outer_product(ModuleText& text, const Instruction& i, const Operands& operands) {
    std::vector<Expression> columns;
    for (std::uint32_t c = 0; c < text.module().type(i.word(1)).count; ++c) {
        Expression factor = plain(primary(operands[1]) + "." + "xyzw"[c]);
        factor.reads = operands[1].reads;
        columns.push_back(binary("*", operands[0], factor));
    }
    return call(text.type(i.word(1)), columns);
}

Expression select(const Operands& operands) {
    return call("select", {operands[2], operands[1], operands[0]});
}

// Bit fields: GLSL counts bits with int, WGSL with u32.
Expression bit_field(const Instruction& i, Operands operands) {
    const std::size_t counts = i.opcode == SpvOpBitFieldInsert ? 2 : 1;
    for (std::size_t k = counts; k < operands.size(); ++k)
        operands[k] = operands[k].literal ? plain(operands[k].text + "u") : call("u32", {operands[k]});
    operands[0] = typed(operands[0]);
    return call(i.opcode == SpvOpBitFieldInsert ? "insertBits" : "extractBits", operands);
}

bool convert(ModuleText& text, const Instruction& i, const Operands& operands, Expression& result) {
    switch (i.opcode) {
        case SpvOpConvertFToS:
        case SpvOpConvertFToU:
        case SpvOpConvertSToF:
        case SpvOpConvertUToF:
        case SpvOpFConvert:
            result = call(text.type(i.word(1)), operands);
            return true;
        case SpvOpBitcast:
            result = bitcast(text, i, operands[0]);
            return true;
        case SpvOpFNegate:
        case SpvOpSNegate:
            result = unary("-", operands[0]);
            return true;
        case SpvOpLogicalNot:
            result = unary("!", operands[0]);
            return true;
        case SpvOpNot:
            result = unary("~", operands[0]);
            return true;
        case SpvOpCopyObject:
        case SpvOpCopyLogical:
        case SpvOpQuantizeToF16:
            result = i.opcode == SpvOpQuantizeToF16 ? call("quantizeToF16", operands) : operands[0];
            return true;
        default:
            return false;
    }
}

bool compose(ModuleText& text, const Instruction& i, const Operands& operands, Expression& result) {
    switch (i.opcode) {
        case SpvOpSelect:
            result = select(operands);
            return true;
        case SpvOpVectorShuffle:
            result = shuffle(text, i, operands);
            return true;
        case SpvOpCompositeConstruct:
            result = construct(text, i, operands);
            return true;
        case SpvOpCompositeExtract:
            result = extract(text, i, operands[0]);
            return true;
        case SpvOpVectorExtractDynamic:
            result = plain(primary(operands[0]) + "[" + operands[1].text + "]");
            result.reads = operands[0].reads;
            result.reads.insert(operands[1].reads.begin(), operands[1].reads.end());
            return true;
        case SpvOpOuterProduct:
            result = outer_product(text, i, operands);
            return true;
        case SpvOpBitFieldInsert:
        case SpvOpBitFieldSExtract:
        case SpvOpBitFieldUExtract:
            result = bit_field(i, operands);
            return true;
        default:
            return false;
    }
}

bool helped(ModuleText& text, const Instruction& i, const Operands& operands, Expression& result) {
    const auto help = [&](const char* kind) {
        const Instruction* constant = text.module().constant(i.word(3));
        const Id type = constant != nullptr ? constant->word(1) : text.module().type_of(i.word(3));
        if (text.module().is_half(type) && (i.opcode == SpvOpIsNan || i.opcode == SpvOpIsInf))
            throw NotTranslated("isnan() and isinf() of 16 bits");
        result = call(text.helper(kind, type), operands);
        return true;
    };
    switch (i.opcode) {
        case SpvOpIsNan:
            return help("is_nan");
        case SpvOpIsInf:
            return help("is_inf");
        case SpvOpFMod:
            return help("float_mod");
        case SpvOpSMod:
            return help("int_mod");
        case SpvOpIAddCarry:
            return help("add_carry");
        case SpvOpISubBorrow:
            return help("subtract_borrow");
        case SpvOpUMulExtended:
            return help("multiply_extended");
        default:
            return false;
    }
}

}  // namespace

Expression of_sign(ModuleText& text, Id type, Id operand, const Expression& result) {
    const Module& module = text.module();
    if (module.is_signed(module.type_of(operand)) == module.is_signed(type)) return result;
    return call("bitcast<" + text.type(type) + ">", {result});
}

namespace {

// Integer operations whose operands and result may differ in their signs: glslang adds an int to an uint that
// is incremented.
bool mixes_signs(std::uint32_t opcode) {
    constexpr std::array all{SpvOpIAdd,       SpvOpISub,      SpvOpIMul,
                             SpvOpBitwiseAnd, SpvOpBitwiseOr, SpvOpBitwiseXor};
    return std::ranges::find(all, static_cast<SpvOp>(opcode)) != all.end();
}

Expression of_same_sign(ModuleText& text, const Instruction& i, const std::string& sign,
                        const Operands& operands) {
    const auto operand = [&](std::size_t k) {
        const Expression& given = operands[k];
        return given.literal ? given : of_sign(text, i.word(1), i.word(3 + k), given);
    };
    return binary(sign, operand(0), operand(1));
}

}  // namespace

bool operation(ModuleText& text, const Instruction& i, const Operands& operands, Expression& result) {
    const auto infix = binary_operators().find(i.opcode);
    const bool vectors = text.module().types.contains(i.word(1)) && text.module().components(i.word(1)) > 1;
    if (infix != binary_operators().end()) {
        result = mixes_signs(i.opcode) ? of_same_sign(text, i, infix->second, operands)
                                       : binary(infix->second, operands[0], operands[1]);
    } else if (const auto function = functions().find(i.opcode); function != functions().end()) {
        result = call(function->second, operands);
        if (i.opcode == SpvOpBitCount) result = of_sign(text, i.word(1), i.word(3), result);
    } else if (const auto opposite = negated_comparisons().find(i.opcode);
               opposite != negated_comparisons().end()) {
        result = unary("!", binary(opposite->second, operands[0], operands[1]));
    } else if (i.opcode == SpvOpLogicalAnd || i.opcode == SpvOpLogicalOr) {
        const std::string sign = i.opcode == SpvOpLogicalAnd ? "&&" : "||";
        result = binary(vectors ? sign.substr(1) : sign, operands[0], operands[1]);
    } else if (i.opcode == SpvOpShiftLeftLogical) {
        result = shift(text, i, operands, "<<");
    } else if (i.opcode == SpvOpShiftRightArithmetic) {
        result = shift(text, i, operands, ">>");
    } else if (i.opcode == SpvOpShiftRightLogical) {
        result = logical_shift(text, i, operands);
    } else {
        return convert(text, i, operands, result) || compose(text, i, operands, result) ||
               helped(text, i, operands, result);
    }
    return true;
}

}  // namespace gloam::shader::internal::wgsl
