// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <map>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

// Images, atomic operations and barriers.
namespace gloam::shader::internal::wgsl {

// Of the operands of an access: that the texels are signed or unsigned integers, which their type says.
constexpr std::uint32_t of_integers = SpvImageOperandsSignExtendMask | SpvImageOperandsZeroExtendMask;

// Coordinates as arguments: WGSL has the layer of an image apart, as an integer.
std::vector<Expression> FunctionWriter::coordinates(Id image, Id coordinate, Statements& out) {
    const Type& type = module_.image_type(module_.type_of(image));
    Expression all = take(coordinate);
    if (!type.arrayed) return {all};
    if (marks_in(all.text).size() != 1 || all.text != mark(marks_in(all.text)[0])) {
        const Id copy = copy_of(coordinate);  // it is written twice
        body_.wanted_names[copy] = "at";
        out.push_back({.kind = StatementKind::assign, .target = copy, .value = all.text});
        all = {.text = mark(copy)};
    }
    const std::uint32_t count = module_.components(module_.type_of(coordinate));
    Expression place = plain(all.text + std::string(".xyz").substr(0, count));
    Expression layer = plain(all.text + "." + "xyzw"[count - 1]);
    if (module_.is_float(module_.type_of(coordinate)))
        layer = call("i32", {call("floor", {binary("+", layer, plain("0.5"))})});
    place.reads = layer.reads = all.reads;
    return {place, layer};
}

void FunctionWriter::image_size(const Instruction& i, Statements& out) {
    const Expression image = take(i.word(3));
    std::vector<Expression> arguments{image};
    if (i.opcode == SpvOpImageQuerySizeLod && !module_.image_type(module_.type_of(i.word(3))).multisampled)
        arguments.push_back(take(i.word(4)));
    Expression size = call("textureDimensions", arguments);
    if (module_.image_type(module_.type_of(i.word(3))).arrayed)
        size = call("vec3u", {size, call("textureNumLayers", {image})});
    define(i.word(2), call(text_.type(i.word(1)), {size}), out);
}

bool FunctionWriter::image_access(const Instruction& i, Statements& out) {
    switch (i.opcode) {
        case SpvOpImageRead: {
            const Expression image = take(i.word(3));
            const bool texture = text_.image_use(facts_.image_of(i.word(3))) == ImageUse::texture;
            std::vector<Expression> arguments = coordinates(i.word(3), i.word(4), out);
            arguments.insert(arguments.begin(), image);
            if (texture) arguments.push_back(plain("0"));
            Expression texel = call("textureLoad", arguments);
            if (!texture) texel.reads.insert(memory);
            define(i.word(2), texel, out);
            return true;
        }
        case SpvOpImageFetch: {
            std::vector<Expression> arguments = coordinates(i.word(3), i.word(4), out);
            arguments.insert(arguments.begin(), take(i.word(3)));
            if ((i.word(5) & ~(SpvImageOperandsLodMask | SpvImageOperandsSampleMask | of_integers)) != 0)
                throw NotTranslated("texelFetchOffset()");
            arguments.push_back(i.words.size() > 6 ? take(i.word(6)) : plain("0"));
            define(i.word(2), call("textureLoad", arguments), out);
            return true;
        }
        case SpvOpImageWrite: {
            std::vector<Expression> arguments = coordinates(i.word(1), i.word(2), out);
            arguments.insert(arguments.begin(), take(i.word(1)));
            arguments.push_back(take(i.word(3)));
            before_change(memory, out);
            out.push_back({.value = call("textureStore", arguments).text});
            return true;
        }
        case SpvOpImage:
            values_[i.word(2)] = take(i.word(3));
            return true;
        case SpvOpImageQuerySize:
        case SpvOpImageQuerySizeLod:
            image_size(i, out);
            return true;
        case SpvOpImageQueryLevels:
            define(i.word(2), call(text_.type(i.word(1)), {call("textureNumLevels", {take(i.word(3))})}),
                   out);
            return true;
        case SpvOpSampledImage:
            values_[i.word(2)] = take(i.word(3));
            samplers_[i.word(2)] = take(i.word(4));
            return true;
        case SpvOpImageSampleImplicitLod:
        case SpvOpImageSampleExplicitLod:
        case SpvOpImageGather:
            sample(i, out);
            return true;
        default:
            if (i.opcode >= SpvOpImageSampleImplicitLod && i.opcode <= SpvOpImageDrefGather)
                throw NotTranslated("a depth comparison, a projective read or derivatives of a texture");
            return false;
    }
}

static const char* name_of_sampling(bool gather, std::uint32_t mask) {
    if (gather) return "textureGather";
    if ((mask & SpvImageOperandsGradMask) != 0) return "textureSampleGrad";
    if ((mask & SpvImageOperandsLodMask) != 0) return "textureSampleLevel";
    return (mask & SpvImageOperandsBiasMask) != 0 ? "textureSampleBias" : "textureSample";
}

// A texture read by its sampler. The operands behind the mask stand in the order of its bits.
void FunctionWriter::sample(const Instruction& i, Statements& out) {
    const bool gather = i.opcode == SpvOpImageGather;
    const bool implicit = i.opcode == SpvOpImageSampleImplicitLod;
    const Type& image = module_.image_type(module_.type_of(i.word(3)));
    if (!module_.is_float(image.element)) throw WgslError("an integer texture with a sampler");
    if (image.depth) throw NotTranslated("a depth comparison of a texture");
    const Id loaded = facts_.image_of(i.word(3));
    const auto apart = samplers_.find(i.word(3));
    std::vector<Expression> arguments = coordinates(i.word(3), i.word(4), out);
    const Expression sampler = apart != samplers_.end() ? apart->second : sampler_of(loaded);
    arguments.insert(arguments.begin(), {take(i.word(3)), sampler});
    const std::size_t at = gather ? 6 : 5;
    const std::uint32_t mask = i.words.size() > at ? i.word(at) : 0;
    std::size_t next = gather ? 7 : 6;
    if (gather) arguments.insert(arguments.begin(), take(i.word(5)));
    if ((mask & SpvImageOperandsBiasMask) != 0) arguments.push_back(take(i.word(next++)));
    if ((mask & SpvImageOperandsLodMask) != 0) arguments.push_back(take(i.word(next++)));
    if ((mask & SpvImageOperandsGradMask) != 0) {
        arguments.push_back(take(i.word(next++)));
        arguments.push_back(take(i.word(next++)));
    }
    if ((mask & SpvImageOperandsConstOffsetMask) != 0) arguments.push_back(take(i.word(next++)));
    constexpr std::uint32_t known = SpvImageOperandsBiasMask | SpvImageOperandsLodMask |
                                    SpvImageOperandsGradMask | SpvImageOperandsConstOffsetMask;
    if ((mask & ~known) != 0) throw NotTranslated("a texture read with an offset that varies");
    if (!implicit) return define(i.word(2), call(name_of_sampling(gather, mask), arguments), out);
    if (shape_.uses[i.word(2)] == 0) return;
    text_.need_derivatives();
    keep(i.word(2), call(name_of_sampling(gather, mask), arguments), out);
}

namespace {

const std::map<std::uint32_t, const char*>& derivative_names() {
    static const std::map<std::uint32_t, const char*> names{{SpvOpDPdx, "dpdx"},
                                                            {SpvOpDPdy, "dpdy"},
                                                            {SpvOpFwidth, "fwidth"},
                                                            {SpvOpDPdxFine, "dpdxFine"},
                                                            {SpvOpDPdyFine, "dpdyFine"},
                                                            {SpvOpFwidthFine, "fwidthFine"},
                                                            {SpvOpDPdxCoarse, "dpdxCoarse"},
                                                            {SpvOpDPdyCoarse, "dpdyCoarse"},
                                                            {SpvOpFwidthCoarse, "fwidthCoarse"}};
    return names;
}

}  // namespace

bool is_derivative(std::uint32_t opcode) {
    return derivative_names().contains(opcode) || opcode == SpvOpImageSampleImplicitLod;
}

// Evaluated where it stands: its result depends on the invocations that run there.
bool FunctionWriter::derivative(const Instruction& i, Statements& out) {
    const auto name = derivative_names().find(i.opcode);
    if (name == derivative_names().end()) return false;
    if (shape_.uses[i.word(2)] == 0) return true;
    text_.need_derivatives();
    keep(i.word(2), call(name->second, {take(i.word(3))}), out);
    return true;
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
    if (i.opcode == SpvOpAtomicCompareExchange) {
        compare_exchange(i, out);
        return true;
    }
    const auto name = names.find(i.opcode);
    if (name == names.end())
        throw NotTranslated(fmt::format("the atomic instruction {} of SPIR-V", i.opcode));
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

// A value that is written twice: a constant, a name, or a variable made for it.
Expression FunctionWriter::written_twice(Id value, Statements& out) {
    const Expression once = take(value);
    const std::vector<Id> marks = marks_in(once.text);
    const bool name = marks.size() == 1 && once.text == mark(marks[0]) && once.reads.empty();
    if (name || module_.constant(value) != nullptr) return once;
    const Id copy = copy_of(value);
    body_.wanted_names[copy] = "t";
    out.push_back({.kind = StatementKind::assign, .target = copy, .value = once.text});
    return {.text = mark(copy)};
}

// The exchange of WGSL may fail although the values are equal; that of GLSL does not.
void FunctionWriter::compare_exchange(const Instruction& i, Statements& out) {
    const Expression place = pointer(i.word(3));
    before_change(memory, out);
    const Expression compared = written_twice(i.word(8), out);
    const Expression value = written_twice(i.word(7), out);
    const Id address = copy_of(i.word(3));
    const Id result = copy_of(i.word(2));
    const auto indexed = chain_reads_.find(i.word(3));
    Expression target = plain("&" + place.text);
    if (indexed != chain_reads_.end() && !indexed->second.empty()) {  // the index may change in between
        body_.wanted_names[address] = "place";
        out.push_back({.kind = StatementKind::assign, .target = address, .value = target.text});
        target = plain(mark(address));
    }
    body_.wanted_names[result] = "exchange";
    const Statement exchange{.kind = StatementKind::assign,
                             .target = result,
                             .value = call("atomicCompareExchangeWeak", {target, compared, value}).text};
    const std::string failed =
        fmt::format("!{0}.exchanged && {0}.old_value == {1}", mark(result), compared.text);
    out.push_back(exchange);
    out.push_back({.kind = StatementKind::loop, .value = failed, .lists = {{exchange}, {}}});
    define(i.word(2), {.text = mark(result) + ".old_value"}, out);
}

void FunctionWriter::barrier(const Instruction& i, Statements& out) {
    if (i.opcode == SpvOpMemoryBarrier)
        throw WgslError("a barrier of memory alone: WGSL has it only together with barrier()");
    if (module_.integer(i.word(1)) == SpvScopeSubgroup) throw WgslError("subgroupBarrier()");
    const std::uint32_t semantics = module_.integer(i.word(3)).value_or(0);
    before_change(memory, out);
    out.push_back({.value = "workgroupBarrier()"});
    memory_barriers(semantics, out);
}

// Of buffers and images; workgroupBarrier() is that of shared variables.
void FunctionWriter::memory_barriers(std::uint32_t semantics, Statements& out) {
    before_change(memory, out);
    if ((semantics & SpvMemorySemanticsUniformMemoryMask) != 0) out.push_back({.value = "storageBarrier()"});
    if ((semantics & SpvMemorySemanticsImageMemoryMask) != 0) out.push_back({.value = "textureBarrier()"});
}

// Operations on a subgroup.

namespace {

// The name in WGSL behind "subgroup", by the instruction of SPIR-V.
const std::map<std::uint32_t, const char*>& plain_names() {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpGroupNonUniformElect, "subgroupElect"},
        {SpvOpGroupNonUniformAll, "subgroupAll"},
        {SpvOpGroupNonUniformAny, "subgroupAny"},
        {SpvOpGroupNonUniformBroadcast, "subgroupBroadcast"},
        {SpvOpGroupNonUniformBroadcastFirst, "subgroupBroadcastFirst"},
        {SpvOpGroupNonUniformBallot, "subgroupBallot"},
        {SpvOpGroupNonUniformShuffle, "subgroupShuffle"},
        {SpvOpGroupNonUniformShuffleXor, "subgroupShuffleXor"},
        {SpvOpGroupNonUniformShuffleUp, "subgroupShuffleUp"},
        {SpvOpGroupNonUniformShuffleDown, "subgroupShuffleDown"},
        {SpvOpGroupNonUniformQuadBroadcast, "quadBroadcast"}};
    return names;
}

const std::map<std::uint32_t, const char*>& sum_names() {
    static const std::map<std::uint32_t, const char*> names{
        {SpvOpGroupNonUniformIAdd, "Add"},       {SpvOpGroupNonUniformFAdd, "Add"},
        {SpvOpGroupNonUniformIMul, "Mul"},       {SpvOpGroupNonUniformFMul, "Mul"},
        {SpvOpGroupNonUniformSMin, "Min"},       {SpvOpGroupNonUniformUMin, "Min"},
        {SpvOpGroupNonUniformFMin, "Min"},       {SpvOpGroupNonUniformSMax, "Max"},
        {SpvOpGroupNonUniformUMax, "Max"},       {SpvOpGroupNonUniformFMax, "Max"},
        {SpvOpGroupNonUniformBitwiseAnd, "And"}, {SpvOpGroupNonUniformBitwiseOr, "Or"},
        {SpvOpGroupNonUniformBitwiseXor, "Xor"}};
    return names;
}

// The function of a sum over the whole subgroup, or over the invocations before this one.
std::string sum_name(const std::string& name, std::uint32_t operation) {
    if (operation == SpvGroupOperationReduce) return "subgroup" + name;
    if (name != "Add" && name != "Mul")
        throw WgslError("a minimum, maximum or bit operation over the invocations before this one");
    if (operation == SpvGroupOperationInclusiveScan) return "subgroupInclusive" + name;
    if (operation == SpvGroupOperationExclusiveScan) return "subgroupExclusive" + name;
    throw WgslError("a subgroup operation over clusters");
}

std::string quad_swap(const Module& module, Id direction) {
    constexpr const char* names[] = {"quadSwapX", "quadSwapY", "quadSwapDiagonal"};
    return names[module.integer(direction).value_or(0) % 3];
}

}  // namespace

bool is_subgroup_operation(std::uint32_t opcode) {
    return opcode >= SpvOpGroupNonUniformElect && opcode <= SpvOpGroupNonUniformQuadSwap;
}

// Evaluated where it stands: its result depends on the invocations that run there.
bool FunctionWriter::subgroup_operation(const Instruction& i, Statements& out) {
    if (!is_subgroup_operation(i.opcode)) return false;
    if (shape_.uses[i.word(2)] == 0) return true;
    std::vector<Expression> arguments = take_all(i);
    std::string name;
    if (const auto plain_name = plain_names().find(i.opcode); plain_name != plain_names().end()) {
        name = plain_name->second;
    } else if (const auto sum = sum_names().find(i.opcode); sum != sum_names().end()) {
        name = sum_name(sum->second, i.word(4));
    } else if (i.opcode == SpvOpGroupNonUniformQuadSwap) {
        name = quad_swap(module_, i.word(5));
        arguments.resize(1);
    } else {
        throw NotTranslated(fmt::format("the subgroup instruction {} of SPIR-V", i.opcode));
    }
    text_.need_extension("subgroups");
    keep(i.word(2), call(name, arguments), out);
    return true;
}

}  // namespace gloam::shader::internal::wgsl
