// SPDX-License-Identifier: MIT
// Functions that WGSL lacks.
#include <fmt/format.h>

#include <stdexcept>

#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
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

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

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
    replace_all(text, "@", name);
    helpers_ += "\n" + text;
    return helper_names_[key] = name;
}

}  // namespace gloam::shader::internal::wgsl
