// SPDX-License-Identifier: MIT
// Instructions of GLSL.std.450.
#include <GLSL.std.450.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "shader/internal/wgsl/expressions.hpp"
#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

constexpr std::pair<std::uint32_t, const char*> names[] = {
    {GLSLstd450Round, "round"},
    {GLSLstd450RoundEven, "round"},
    {GLSLstd450Trunc, "trunc"},
    {GLSLstd450FAbs, "abs"},
    {GLSLstd450SAbs, "abs"},
    {GLSLstd450FSign, "sign"},
    {GLSLstd450SSign, "sign"},
    {GLSLstd450Floor, "floor"},
    {GLSLstd450Ceil, "ceil"},
    {GLSLstd450Fract, "fract"},
    {GLSLstd450Radians, "radians"},
    {GLSLstd450Degrees, "degrees"},
    {GLSLstd450Sin, "sin"},
    {GLSLstd450Cos, "cos"},
    {GLSLstd450Tan, "tan"},
    {GLSLstd450Asin, "asin"},
    {GLSLstd450Acos, "acos"},
    {GLSLstd450Atan, "atan"},
    {GLSLstd450Sinh, "sinh"},
    {GLSLstd450Cosh, "cosh"},
    {GLSLstd450Tanh, "tanh"},
    {GLSLstd450Asinh, "asinh"},
    {GLSLstd450Acosh, "acosh"},
    {GLSLstd450Atanh, "atanh"},
    {GLSLstd450Atan2, "atan2"},
    {GLSLstd450Pow, "pow"},
    {GLSLstd450Exp, "exp"},
    {GLSLstd450Log, "log"},
    {GLSLstd450Exp2, "exp2"},
    {GLSLstd450Log2, "log2"},
    {GLSLstd450Sqrt, "sqrt"},
    {GLSLstd450InverseSqrt, "inverseSqrt"},
    {GLSLstd450Determinant, "determinant"},
    {GLSLstd450ModfStruct, "modf"},
    {GLSLstd450FMin, "min"},
    {GLSLstd450UMin, "min"},
    {GLSLstd450SMin, "min"},
    {GLSLstd450FMax, "max"},
    {GLSLstd450UMax, "max"},
    {GLSLstd450SMax, "max"},
    {GLSLstd450NMin, "min"},
    {GLSLstd450NMax, "max"},
    {GLSLstd450FClamp, "clamp"},
    {GLSLstd450UClamp, "clamp"},
    {GLSLstd450SClamp, "clamp"},
    {GLSLstd450NClamp, "clamp"},
    {GLSLstd450FMix, "mix"},
    {GLSLstd450Step, "step"},
    {GLSLstd450SmoothStep, "smoothstep"},
    {GLSLstd450Fma, "fma"},
    {GLSLstd450FrexpStruct, "frexp"},
    {GLSLstd450Ldexp, "ldexp"},
    {GLSLstd450PackSnorm4x8, "pack4x8snorm"},
    {GLSLstd450PackUnorm4x8, "pack4x8unorm"},
    {GLSLstd450PackSnorm2x16, "pack2x16snorm"},
    {GLSLstd450PackUnorm2x16, "pack2x16unorm"},
    {GLSLstd450PackHalf2x16, "pack2x16float"},
    {GLSLstd450UnpackSnorm4x8, "unpack4x8snorm"},
    {GLSLstd450UnpackUnorm4x8, "unpack4x8unorm"},
    {GLSLstd450UnpackSnorm2x16, "unpack2x16snorm"},
    {GLSLstd450UnpackUnorm2x16, "unpack2x16unorm"},
    {GLSLstd450UnpackHalf2x16, "unpack2x16float"},
    {GLSLstd450Length, "length"},
    {GLSLstd450Distance, "distance"},
    {GLSLstd450Cross, "cross"},
    {GLSLstd450Normalize, "normalize"},
    {GLSLstd450FaceForward, "faceForward"},
    {GLSLstd450Reflect, "reflect"},
    {GLSLstd450Refract, "refract"},
    {GLSLstd450FindILsb, "firstTrailingBit"},
    {GLSLstd450FindSMsb, "firstLeadingBit"},
    {GLSLstd450FindUMsb, "firstLeadingBit"},
};

// In GLSL these are also functions of scalars, in WGSL of vectors alone.
bool of_scalars(std::uint32_t instruction, const std::vector<Expression>& a, Expression& result) {
    switch (instruction) {
        case GLSLstd450Normalize:
            result = call("sign", {a[0]});
            return true;
        case GLSLstd450Reflect: {
            const Expression twice = binary("*", plain("2.0"), binary("*", a[1], a[0]));
            result = binary("-", a[0], binary("*", twice, a[1]));
            return true;
        }
        case GLSLstd450FaceForward:
            result =
                call("select", {unary("-", a[0]), a[0], binary("<", binary("*", a[1], a[2]), plain("0.0"))});
            return true;
        case GLSLstd450Refract:
            throw NotTranslated("refract() of scalars");
        default:
            return false;
    }
}

}  // namespace

bool extended_operation(ModuleText& text, const Instruction& i, const std::vector<Expression>& operands,
                        Expression& result) {
    const std::uint32_t which = i.word(4);
    const Module& module = text.module();
    const Id type = i.word(1);
    if (which == GLSLstd450MatrixInverse) {
        result = call(text.helper(fmt::format("inverse{}", module.type(type).count), 0), operands);
        return true;
    }
    if (module.type(type).kind == Type::Kind::float_ && of_scalars(which, operands, result)) return true;
    const auto* const name = std::ranges::find(names, which, &std::pair<std::uint32_t, const char*>::first);
    if (name == std::end(names))
        throw NotTranslated(fmt::format("the instruction {} of GLSL.std.450", which));
    const bool bits =
        which == GLSLstd450FindILsb || which == GLSLstd450FindSMsb || which == GLSLstd450FindUMsb;
    result = call(name->second, operands);
    if (!bits) return true;
    // GLSL gives int, WGSL the type of the argument.
    const Instruction* constant = module.constant(i.word(5));
    const Id from = constant != nullptr ? constant->word(1) : module.type_of(i.word(5));
    if (module.is_signed(from) != module.is_signed(type))
        result = call("bitcast<" + text.type(type) + ">", {result});
    return true;
}

}  // namespace gloam::shader::internal::wgsl
