// SPDX-License-Identifier: MIT
// Images, atomic operations and barriers.
#include <fmt/format.h>

#include <map>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

bool FunctionWriter::image_access(const Instruction& i, Statements& out) {
    switch (i.opcode) {
        case SpvOpImageRead: {
            const Expression image = take(i.word(3));
            const bool texture = text_.image_use(facts_.image_of(i.word(3))) == ImageUse::texture;
            std::vector<Expression> arguments{image, take(i.word(4))};
            if (texture) arguments.push_back(plain("0"));
            Expression texel = call("textureLoad", arguments);
            if (!texture) texel.reads.insert(memory);
            define(i.word(2), texel, out);
            return true;
        }
        case SpvOpImageFetch: {
            const Expression level = i.words.size() > 6 ? take(i.word(6)) : plain("0");
            define(i.word(2), call("textureLoad", {take(i.word(3)), take(i.word(4)), level}), out);
            return true;
        }
        case SpvOpImageWrite: {
            const Expression write =
                call("textureStore", {take(i.word(1)), take(i.word(2)), take(i.word(3))});
            before_change(memory, out);
            out.push_back({.value = write.text});
            return true;
        }
        case SpvOpImage:
            values_[i.word(2)] = take(i.word(3));
            return true;
        case SpvOpImageQuerySize:
        case SpvOpImageQuerySizeLod: {
            std::vector<Expression> arguments{take(i.word(3))};
            if (i.opcode == SpvOpImageQuerySizeLod) arguments.push_back(take(i.word(4)));
            define(i.word(2), call(text_.type(i.word(1)), {call("textureDimensions", arguments)}), out);
            return true;
        }
        case SpvOpImageSampleImplicitLod:
        case SpvOpImageSampleExplicitLod:
        case SpvOpSampledImage:
            throw WgslError("a texture with its sampler: read it with texelFetch()");
        default:
            return false;
    }
}

bool FunctionWriter::atomic_access(const Instruction& i, Statements& out) {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpAtomicLoad, "atomicLoad"}, {SpvOpAtomicExchange, "atomicExchange"},
        {SpvOpAtomicIAdd, "atomicAdd"},  {SpvOpAtomicISub, "atomicSub"},
        {SpvOpAtomicSMin, "atomicMin"},  {SpvOpAtomicUMin, "atomicMin"},
        {SpvOpAtomicSMax, "atomicMax"},  {SpvOpAtomicUMax, "atomicMax"},
        {SpvOpAtomicAnd, "atomicAnd"},   {SpvOpAtomicOr, "atomicOr"},
        {SpvOpAtomicXor, "atomicXor"}};
    if (i.opcode < SpvOpAtomicLoad || i.opcode > SpvOpAtomicXor) return false;
    const auto name = names.find(i.opcode);
    if (name == names.end()) throw WgslError(fmt::format("the atomic instruction {} of SPIR-V", i.opcode));
    std::vector<Expression> arguments{plain("&" + pointer(i.word(3)).text)};
    if (i.words.size() > 6) arguments.push_back(take(i.word(6)));
    const Expression result = call(name->second, arguments);
    before_change(memory, out);
    if (shape_.uses[i.word(2)] == 0) {
        out.push_back({.value = result.text});
    } else {
        keep(i.word(2), result, out);
    }
    return true;
}

void FunctionWriter::barrier(const Instruction& i, Statements& out) {
    if (i.opcode == SpvOpMemoryBarrier)
        throw WgslError("a barrier of memory alone: WGSL has it only together with barrier()");
    const std::uint32_t semantics = module_.integer(i.word(3)).value_or(0);
    before_change(memory, out);
    out.push_back({.value = "workgroupBarrier()"});
    if ((semantics & SpvMemorySemanticsUniformMemoryMask) != 0) out.push_back({.value = "storageBarrier()"});
    if ((semantics & SpvMemorySemanticsImageMemoryMask) != 0) out.push_back({.value = "textureBarrier()"});
}

}  // namespace gloam::shader::internal::wgsl
