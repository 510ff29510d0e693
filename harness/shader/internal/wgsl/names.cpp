// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/names.hpp"

#include <cctype>
#include <sstream>

namespace gloam::shader::internal::wgsl {
namespace {

std::set<std::string> words_of(const char* text) {
    std::istringstream stream(text);
    std::set<std::string> words;
    for (std::string word; stream >> word;) words.insert(word);
    return words;
}

// Sections "Keywords" and "Reserved Words" of the specification of WGSL, and its predeclared types.
constexpr const char* reserved_words =
    "alias break case const const_assert continue continuing default diagnostic discard else enable false fn "
    "for if let loop override requires return struct switch true var while "
    "NULL Self abstract active alignas alignof as asm asm_fragment async attribute auto await become "
    "cast catch class co_await co_return co_yield coherent column_major common compile compile_fragment "
    "concept const_cast consteval constexpr constinit crate debugger decltype delete demote "
    "demote_to_helper do dynamic_cast enum explicit export extends extern external fallthrough filter "
    "final finally friend from fxgroup get goto groupshared highp impl implements import inline instanceof "
    "interface layout lowp macro macro_rules match mediump meta mod module move mut mutable namespace new "
    "nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null nullptr of operator "
    "package packoffset partial pass patch pixelfragment precise precision premerge priv protected pub "
    "public readonly ref regardless register reinterpret_cast require resource restrict self set shared "
    "sizeof smooth snorm static static_assert static_cast std subroutine super target template this "
    "thread_local throw trait try type typedef typeid typename typeof union unless unorm unsafe unsized "
    "use using varying virtual volatile wgsl where with writeonly yield "
    "array atomic bool f16 f32 i32 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ptr "
    "sampler sampler_comparison texture_1d texture_2d texture_3d texture_cube texture_storage_2d u32 vec2 "
    "vec3 vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u mat2x2f mat2x3f mat2x4f mat3x2f "
    "mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f function private workgroup uniform storage read write "
    "read_write";

constexpr const char* builtin_functions =
    "bitcast all any select arrayLength abs acos acosh asin asinh atan atanh atan2 ceil clamp cos cosh "
    "countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot exp exp2 "
    "extractBits faceForward firstLeadingBit firstTrailingBit floor fma fract frexp insertBits inverseSqrt "
    "ldexp length log log2 max min mix modf normalize pow quantizeToF16 radians reflect refract reverseBits "
    "round saturate sign sin sinh smoothstep sqrt step tan tanh transpose trunc dpdx dpdy fwidth "
    "textureDimensions textureLoad textureStore textureSampleLevel textureNumLevels atomicLoad atomicStore "
    "atomicAdd atomicMax atomicMin atomicAnd atomicOr atomicXor atomicExchange pack4x8snorm pack4x8unorm "
    "pack2x16snorm pack2x16unorm pack2x16float unpack4x8snorm unpack4x8unorm unpack2x16snorm "
    "unpack2x16unorm unpack2x16float storageBarrier textureBarrier workgroupBarrier";

}  // namespace

bool is_reserved(const std::string& word) {
    static const std::set<std::string> words = words_of(reserved_words);
    return words.contains(word);
}

bool is_builtin(const std::string& word) {
    static const std::set<std::string> words = words_of(builtin_functions);
    return words.contains(word);
}

std::string identifier(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool usable = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        if (usable) result += c;
    }
    while (!result.empty() &&
           (result.front() == '_' || std::isdigit(static_cast<unsigned char>(result.front()))))
        result.erase(result.begin());
    if (result.empty()) return "unnamed";
    if (is_reserved(result)) result += '_';
    return result;
}

std::string Names::take(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
}

}  // namespace gloam::shader::internal::wgsl
