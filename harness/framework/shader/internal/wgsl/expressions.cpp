// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/function_writer.hpp"

#include <GLSL.std.450.h>
#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

struct Binding {
    Level level;
    Level left;  // the loosest operands that need no brackets
    Level right;
};

Binding binding_of(const std::string& operation) {
    static const std::map<std::string, Binding> bindings{
        {"*", {Level::product, Level::product, Level::unary}},
        {"/", {Level::product, Level::product, Level::unary}},
        {"%", {Level::product, Level::product, Level::unary}},
        {"+", {Level::sum, Level::sum, Level::product}},
        {"-", {Level::sum, Level::sum, Level::product}},
        {"<<", {Level::bits, Level::unary, Level::unary}},
        {">>", {Level::bits, Level::unary, Level::unary}},
        {"&", {Level::bits, Level::unary, Level::unary}},
        {"|", {Level::bits, Level::unary, Level::unary}},
        {"^", {Level::bits, Level::unary, Level::unary}},
        {"&&", {Level::logic, Level::relation, Level::relation}},
        {"||", {Level::logic, Level::relation, Level::relation}},
    };
    const auto found = bindings.find(operation);
    return found != bindings.end() ? found->second : Binding{Level::relation, Level::sum, Level::sum};
}

bool chains(const std::string& operation) {
    return operation == "&" || operation == "|" || operation == "^" || operation == "&&" || operation == "||";
}

std::string part(const Expression& a, Level loosest, const std::string& operation) {
    const bool chain = chains(operation) && a.operation == operation;
    return a.level <= loosest || chain ? a.text : "(" + a.text + ")";
}

}  // namespace

Expression plain(std::string text) {
    return {.text = std::move(text)};
}

Expression typed(Expression a) {
    if (!a.literal) return a;
    a.text = a.typed;
    a.literal = false;
    return a;
}

Expression binary(const std::string& operation, const Expression& a, const Expression& b) {
    if (a.literal && b.literal) return binary(operation, typed(a), typed(b));
    const Binding binding = binding_of(operation);
    Expression result{
        .text = part(a, binding.left, operation) + " " + operation + " " + part(b, binding.right, ""),
        .level = binding.level,
        .operation = chains(operation) ? operation : ""};
    result.reads = a.reads;
    result.reads.insert(b.reads.begin(), b.reads.end());
    return result;
}

Expression unary(const std::string& operation, const Expression& a) {
    const Expression b = typed(a);
    Expression result{.text = operation + (b.level == Level::primary ? b.text : "(" + b.text + ")"),
                      .level = Level::unary,
                      .reads = b.reads};
    return result;
}

std::string primary(const Expression& a) {
    return a.level == Level::primary ? a.text : "(" + a.text + ")";
}

Expression call(const std::string& function, std::vector<Expression> arguments) {
    const bool constant = std::ranges::all_of(arguments, &Expression::literal);
    const bool constructor = function.starts_with("vec") || function.starts_with("mat");
    Expression result;
    std::string list;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        Expression& a = arguments[k];
        if (constant && !constructor) a = typed(a);
        // `f(a < b, c > d)` would be read as a list of types.
        const bool looks_like_types =
            a.level == Level::relation && a.text.find(" < ") != std::string::npos &&
            std::any_of(arguments.begin() + static_cast<std::ptrdiff_t>(k) + 1, arguments.end(),
                        [](const Expression& later) { return later.text.find('>') != std::string::npos; });
        list += (list.empty() ? "" : ", ") + (looks_like_types ? "(" + a.text + ")" : a.text);
        result.reads.insert(a.reads.begin(), a.reads.end());
    }
    result.text = function + "(" + list + ")";
    return result;
}

namespace {

// Words of an instruction, counted from its first one.
struct Range {
    std::size_t first;
    std::size_t end;
};

// Where the IDs stand that an instruction uses; the rest are literals.
Range ids_of(const Instruction& i, std::size_t first) {
    const std::size_t end = i.words.size();
    switch (i.opcode) {
        case SpvOpCompositeExtract:
        case SpvOpLoad:
        case SpvOpArrayLength:
            return {first, first + 1};
        case SpvOpCompositeInsert:
        case SpvOpVectorShuffle:
        case SpvOpStore:
            return {first, first + 2};
        case SpvOpSwitch:
            return {1, 2};
        case SpvOpBranchConditional:
            return {1, 2};
        case SpvOpBranch:
            return {0, 0};
        default:
            return {first, end};
    }
}

// The word that says which further operands an access to an image has.
std::size_t mask_of_image_operands(std::uint32_t opcode) {
    switch (opcode) {
        case SpvOpImageSampleDrefImplicitLod:
        case SpvOpImageSampleDrefExplicitLod:
        case SpvOpImageSampleProjDrefImplicitLod:
        case SpvOpImageSampleProjDrefExplicitLod:
        case SpvOpImageGather:
        case SpvOpImageDrefGather:
            return 6;
        default:
            return 5;
    }
}

}  // namespace

Id result_of(const Instruction& i) {
    const auto [has_result, has_type] = spirv::result_shape(i.opcode);
    if (!has_result) return 0;
    return i.word(has_type ? 2 : 1);
}

std::vector<Id> operands(const Instruction& i) {
    if (i.opcode == SpvOpExtInst) return {i.words.begin() + 5, i.words.end()};
    if (i.opcode == SpvOpImageWrite) return {i.word(1), i.word(2), i.word(3)};
    if (i.opcode == SpvOpImageRead || i.opcode == SpvOpImageFetch ||
        (i.opcode >= SpvOpImageSampleImplicitLod && i.opcode <= SpvOpImageDrefGather)) {
        const std::size_t mask = mask_of_image_operands(i.opcode);
        std::vector<Id> ids;
        for (std::size_t w = 3; w < i.words.size(); ++w)
            if (w != mask) ids.push_back(i.word(w));
        return ids;
    }
    if (is_subgroup_operation(i.opcode)) {
        const bool sum = i.opcode >= SpvOpGroupNonUniformIAdd && i.opcode <= SpvOpGroupNonUniformLogicalXor;
        const bool count = i.opcode == SpvOpGroupNonUniformBallotBitCount;
        const std::size_t first = std::min<std::size_t>(sum || count ? 5 : 4, i.words.size());
        return {i.words.begin() + static_cast<std::ptrdiff_t>(first), i.words.end()};
    }
    const auto [has_result, has_type] = spirv::result_shape(i.opcode);
    const Range range = ids_of(i, 1U + (has_result ? 1 : 0) + (has_type ? 1 : 0));
    std::vector<Id> ids;
    for (std::size_t w = range.first; w < range.end && w < i.words.size(); ++w) {
        const bool block_of_phi = i.opcode == SpvOpPhi && (w - range.first) % 2 == 1;
        if (!block_of_phi) ids.push_back(i.word(w));
    }
    return ids;
}

// Instructions of GLSL.std.450.

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
    if (module.type(type).kind == Type::Kind::real && of_scalars(which, operands, result)) return true;
    const auto* const name = std::ranges::find(names, which, &std::pair<std::uint32_t, const char*>::first);
    if (name == std::end(names))
        throw NotTranslated(fmt::format("the instruction {} of GLSL.std.450", which));
    result = call(name->second, operands);
    if (which == GLSLstd450FindILsb || which == GLSLstd450FindSMsb || which == GLSLstd450FindUMsb)
        result = of_sign(text, type, i.word(5), result);
    return true;
}

}  // namespace gloam::shader::internal::wgsl
