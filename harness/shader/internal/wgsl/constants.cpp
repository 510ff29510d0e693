// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "shader/internal/wgsl/expressions.hpp"
#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

// The shortest decimal number that gives the float, or a hexadecimal one where a decimal might not.
std::string digits_of(float value) {
    constexpr float largest = 3.4e38F;
    if (std::abs(value) > largest || (value != 0.0F && std::abs(value) < 0x1p-126F))
        return fmt::format("{:a}", value);
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    std::string text(buffer, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

bool is_special(std::uint32_t bits) {
    return (bits & 0x7f800000U) == 0x7f800000U;
}

}  // namespace

Expression float_literal(std::uint32_t bits) {
    const auto value = std::bit_cast<float>(bits);
    const std::string text = digits_of(value);
    const bool same = static_cast<float>(std::strtod(text.c_str(), nullptr)) == value;
    return {.text = same ? text : text + "f",
            .level = std::signbit(value) ? Level::unary : Level::primary,
            .literal = true,
            .typed = text + "f"};
}

namespace {

// A constant of 16 bits, with the suffix of its type.
Expression half_literal(std::uint32_t bits) {
    const std::uint32_t exponent = (bits >> 10U) & 0x1fU;
    const auto fraction = static_cast<float>(bits & 0x3ffU);
    if (exponent == 0x1fU) throw NotTranslated("an infinite or NaN constant of 16 bits");
    const float size = exponent == 0 ? std::ldexp(fraction, -24)
                                     : std::ldexp(1024.0F + fraction, static_cast<int>(exponent) - 25);
    const bool negative = (bits & 0x8000U) != 0;
    return {.text = (negative ? "-" : "") + digits_of(size) + "h",
            .level = negative ? Level::unary : Level::primary};
}

}  // namespace

Expression ModuleText::number(const Instruction& i) {
    const std::uint32_t bits = i.word(3);
    switch (module_.type(i.word(1)).kind) {
        case TypeKind::float_:
            if (module_.is_half(i.word(1))) return half_literal(bits);
            // A constant expression of WGSL has no infinity and no NaN.
            if (is_special(bits)) return plain(fmt::format("{}(0x{:x}u)", helper("float_of_bits", 0), bits));
            return float_literal(bits);
        case TypeKind::int_: {
            const auto value = static_cast<std::int32_t>(bits);
            if (bits == 0x80000000U) return plain("bitcast<i32>(0x80000000u)");
            return {.text = std::to_string(value),
                    .level = value < 0 ? Level::unary : Level::primary,
                    .literal = true,
                    .typed = std::to_string(value) + "i"};
        }
        default:
            if (bits > 0xffffU) return plain(fmt::format("0x{:x}u", bits));
            return plain(fmt::format("{}u", bits));
    }
}

Expression ModuleText::composite(const Instruction& i) {
    std::vector<Expression> parts;
    for (std::size_t w = 3; w < i.words.size(); ++w) parts.push_back(constant(i.word(w)));
    const bool vector = module_.type(i.word(1)).kind == TypeKind::vector;
    const bool equal =
        std::ranges::all_of(parts, [&](const Expression& p) { return p.text == parts[0].text; });
    if (vector && equal) parts.resize(1);
    Expression result{.text = type(i.word(1)) + "("};
    for (const Expression& part : parts) result.text += (&part == parts.data() ? "" : ", ") + part.text;
    result.text += ")";
    return result;
}

Expression ModuleText::computed(const Instruction& i) {
    // The opcode is the third operand: its instruction has the operands that follow.
    Spirv words{0, i.word(1), i.word(2)};
    words.insert(words.end(), i.words.begin() + 4, i.words.end());
    const Instruction inner{.at = 0, .opcode = i.word(3), .words = words};
    std::vector<Expression> parts;
    for (const Id id : operands(inner)) parts.push_back(constant(id));
    // int(x) of an unsigned x is x + 0 with a signed result.
    const Instruction* first = module_.constant(inner.word(3));
    const bool mixed = first != nullptr &&
                       module_.is_signed(first->word(1)) != module_.is_signed(i.word(1)) &&
                       inner.opcode == SpvOpIAdd;
    if (mixed) return call(type(i.word(1)), {parts[0]});
    Expression result;
    if (!operation(*this, inner, parts, result))
        throw NotTranslated("a specialization constant that is computed");
    return result;
}

Expression ModuleText::constant(Id id) {
    const Instruction* i = module_.constant(id);
    if (i == nullptr) throw NotTranslated("a constant of another kind");
    if (names_.contains(id)) {
        overrides_used_.insert(id);
        return plain(entry_of(names_, id, "a constant without a name"));
    }
    switch (i->opcode) {
        case SpvOpConstantTrue:
        case SpvOpSpecConstantTrue:
            return plain("true");
        case SpvOpConstantFalse:
        case SpvOpSpecConstantFalse:
            return plain("false");
        case SpvOpConstant:
        case SpvOpSpecConstant:
            return number(*i);
        case SpvOpConstantComposite:
        case SpvOpSpecConstantComposite:
            return composite(*i);
        case SpvOpSpecConstantOp:
            return computed(*i);
        default:  // OpConstantNull, OpUndef
            return plain(type(i->word(1)) + "()");
    }
}

std::string ModuleText::overrides(const std::set<Id>& used) {
    std::string text;
    for (const Id id : module_.constant_order) {
        if (!used.contains(id)) continue;
        const Instruction& i = *module_.constant(id);
        const std::string value = i.opcode == SpvOpSpecConstantTrue    ? "true"
                                  : i.opcode == SpvOpSpecConstantFalse ? "false"
                                                                       : number(i).text;
        text += comment("", module_.name_of(id), "");
        text += fmt::format("@id({}) override {}: {} = {};\n", *module_.decorations_of(id).spec_id,
                            entry_of(names_, id, "a constant without a name"), type(i.word(1)), value);
    }
    return text;
}

}  // namespace gloam::shader::internal::wgsl
