// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "base/text.hpp"
#include "shader/internal/wgsl/function_writer.hpp"
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
    const Type& type = module_.type(i.word(1));
    if (type.kind == TypeKind::real) {
        if (type.width == 16) return half_literal(bits);
        // A constant expression of WGSL has no infinity and no NaN.
        if (is_special(bits)) return plain(fmt::format("{}(0x{:x}u)", helper("float_of_bits", 0), bits));
        return float_literal(bits);
    }
    if (type.is_signed) {
        const auto value = static_cast<std::int32_t>(bits);
        if (bits == 0x80000000U) return plain("bitcast<i32>(0x80000000u)");
        return {.text = std::to_string(value),
                .level = value < 0 ? Level::unary : Level::primary,
                .literal = true,
                .typed = std::to_string(value) + "i"};
    }
    return plain(bits > 0xffffU ? fmt::format("0x{:x}u", bits) : fmt::format("{}u", bits));
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

// Functions that WGSL lacks.

namespace {

// @: the function's name. T: the type of its operands. U, B: unsigned integers and Booleans of its size.
struct Helper {
    const char* kind;
    const char* text;
};

constexpr Helper helpers[] = {
    {"is_nan", R"(// Whether x is NaN. WGSL has no isnan().
fn @(x: T) -> B {
    return (bitcast<U>(x) & U(0x7fffffffu)) > U(0x7f800000u);
}
)"},
    {"is_inf", R"(// Whether x is infinite. WGSL has no isinf().
fn @(x: T) -> B {
    return (bitcast<U>(x) & U(0x7fffffffu)) == U(0x7f800000u);
}
)"},
    {"float_of_bits", R"(// The float with these bits: infinity and NaN, which constants of WGSL cannot be.
fn @(bits: u32) -> f32 {
    var variable_bits = bits;
    return bitcast<f32>(variable_bits);
}
)"},
    {"float_mod", R"(// mod() of GLSL: the remainder has the sign of y.
fn @(x: T, y: T) -> T {
    return x - y * floor(x / y);
}
)"},
    {"int_mod", R"(// The remainder with the sign of y.
fn @(x: T, y: T) -> T {
    let r = x % y;
    return select(r, r + y, (r != T()) & ((r < T()) != (y < T())));
}
)"},
    {"add_carry", R"(// uaddCarry() of GLSL: the sum, and 1 in y where it does not fit.
fn @(a: u32, b: u32) -> vec2u {
    let sum = a + b;
    return vec2u(sum, select(0u, 1u, sum < a));
}
)"},
    {"subtract_borrow", R"(// usubBorrow() of GLSL: the difference, and 1 in y where a is less than b.
fn @(a: u32, b: u32) -> vec2u {
    return vec2u(a - b, select(0u, 1u, a < b));
}
)"},
    {"multiply_extended", R"(// umulExtended() of GLSL: the low word of the product in x, the high one in y.
fn @(a: u32, b: u32) -> vec2u {
    let low = (a & 0xffffu) * (b & 0xffffu);
    let middle_a = (a >> 16u) * (b & 0xffffu) + (low >> 16u);
    let middle_b = (a & 0xffffu) * (b >> 16u) + (middle_a & 0xffffu);
    let high = (a >> 16u) * (b >> 16u) + (middle_a >> 16u) + (middle_b >> 16u);
    return vec2u(a * b, high);
}
)"},
    {"inverse2", R"(// The inverse of a matrix. WGSL has no inverse().
fn @(m: mat2x2f) -> mat2x2f {
    return mat2x2f(m[1].y, -m[0].y, -m[1].x, m[0].x) * (1.0 / determinant(m));
}
)"},
    {"inverse3", R"(// The inverse of a matrix. WGSL has no inverse().
fn @(m: mat3x3f) -> mat3x3f {
    let rows = mat3x3f(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    return transpose(rows) * (1.0 / determinant(m));
}
)"},
    {"inverse4", R"(// The inverse of a matrix, by the minors of its halves. WGSL has no inverse().
fn @(m: mat4x4f) -> mat4x4f {
    let a = m[0].xyz;
    let b = m[1].xyz;
    let c = m[2].xyz;
    let d = m[3].xyz;
    let s = cross(a, b);
    let t = cross(c, d);
    let u = a * m[1].w - b * m[0].w;
    let v = c * m[3].w - d * m[2].w;
    let scale = 1.0 / (dot(s, v) + dot(t, u));
    let rows = mat4x4f(
        vec4f((cross(b, v) + t * m[1].w) * scale, -dot(b, t) * scale),
        vec4f((cross(v, a) - t * m[0].w) * scale, dot(a, t) * scale),
        vec4f((cross(d, u) + s * m[3].w) * scale, -dot(d, s) * scale),
        vec4f((cross(u, c) - s * m[2].w) * scale, dot(c, s) * scale));
    return transpose(rows);
}
)"},
};

// Replaces a letter where it stands alone as a type.
void replace_type(std::string& text, char letter, const std::string& to) {
    std::string result;
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    bool comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.compare(i, 2, "//") == 0) comment = true;
        if (text[i] == '\n') comment = false;
        const bool alone = text[i] == letter && (i == 0 || !is_word(text[i - 1])) &&
                           (i + 1 == text.size() || !is_word(text[i + 1]));
        if (alone && !comment) {
            result += to;
        } else {
            result += text[i];
        }
    }
    text = result;
}

std::string text_of(const std::string& kind) {
    for (const Helper& helper : helpers)
        if (kind == helper.kind) return helper.text;
    throw std::logic_error("no helper " + kind);
}

}  // namespace

std::string ModuleText::helper(const std::string& kind, Id operand_type) {
    const std::string operand = operand_type == 0 ? "" : type(operand_type);
    const std::string key = kind + "<" + operand;
    const auto known = helper_names_.find(key);
    if (known != helper_names_.end()) return known->second;
    const std::uint32_t n = operand_type == 0 ? 1 : module_.components(operand_type);
    const std::string name = names.take(n > 1 ? fmt::format("{}_vec{}", kind, n) : kind);
    std::string text = text_of(kind);
    replace_type(text, 'T', operand);
    replace_type(text, 'U', n > 1 ? fmt::format("vec{}u", n) : "u32");
    replace_type(text, 'B', n > 1 ? fmt::format("vec{}<bool>", n) : "bool");
    helpers_ += "\n" + base::replaced(text, "@", name);
    return helper_names_[key] = name;
}

}  // namespace gloam::shader::internal::wgsl
