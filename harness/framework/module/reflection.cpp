// SPDX-License-Identifier: MIT
#include "module/reflection.hpp"

#include <spirv.h>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "module/module.hpp"

namespace gloam::module {
namespace {

using spirv::Id;
using Kind = spirv::Type::Kind;

std::string scalar_name(const spirv::Type& type) {
    if (type.kind == Kind::boolean) return "bool";
    if (type.kind == Kind::integer && type.width == 32) return type.is_signed ? "int" : "uint";
    if (type.kind == Kind::real && type.width == 32) return "float";
    throw std::runtime_error("a member that is no float, int, uint, bool or structure of them");
}

std::string format_name(std::uint32_t format) {
    static const std::map<std::uint32_t, std::string> names{
        {SpvImageFormatRgba32f, "rgba32f"},   {SpvImageFormatRgba16f, "rgba16f"},
        {SpvImageFormatR32f, "r32f"},         {SpvImageFormatRg32f, "rg32f"},
        {SpvImageFormatRg16f, "rg16f"},       {SpvImageFormatR16f, "r16f"},
        {SpvImageFormatRgba8, "rgba8"},       {SpvImageFormatR8, "r8"},
        {SpvImageFormatRgba16ui, "rgba16ui"}, {SpvImageFormatRg16ui, "rg16ui"},
        {SpvImageFormatR16ui, "r16ui"},       {SpvImageFormatRgba32ui, "rgba32ui"},
        {SpvImageFormatRg32ui, "rg32ui"},     {SpvImageFormatR32ui, "r32ui"},
        {SpvImageFormatRgb10A2, "rgb10_a2"},  {SpvImageFormatUnknown, ""}};
    const auto found = names.find(format);
    if (found == names.end()) throw std::runtime_error("an image of a format that has no name here");
    return found->second;
}

// "2DArray", "Cube"
std::string shape_of(const spirv::Type& image) {
    static const std::map<std::uint32_t, std::string> names{
        {SpvDim1D, "1D"}, {SpvDim2D, "2D"}, {SpvDim3D, "3D"}, {SpvDimCube, "Cube"}};
    const auto found = names.find(image.dimension);
    std::string shape = found == names.end() ? "Buffer" : found->second;
    if (image.multisampled) shape += "MS";
    if (image.arrayed) shape += "Array";
    return image.depth ? shape + "Shadow" : shape;
}

// Of a variable of this storage class and type; empty: no binding.
std::optional<BindingType> binding_type(std::uint32_t storage, const spirv::Type& type) {
    if (storage == SpvStorageClassUniform) return BindingType::uniform_buffer;
    if (storage == SpvStorageClassStorageBuffer) return BindingType::storage_buffer;
    if (storage != SpvStorageClassUniformConstant || type.dimension == SpvDimSubpassData) return std::nullopt;
    if (type.kind == Kind::sampled_image) return BindingType::sampled_image;
    if (type.kind == Kind::sampler) return BindingType::sampler;
    if (type.kind != Kind::image) return std::nullopt;
    return type.stored ? BindingType::storage_image : BindingType::texture;
}

// Bytes up to the end of the last member; an unbounded array has none.
std::size_t size_of(const std::vector<LaidOut>& members) {
    std::size_t size = 0;
    for (const LaidOut& member : members) {
        const bool unbounded = !member.sizes.empty() && member.sizes.front() == 0;
        size = std::max(size, member.offset + (unbounded ? 0 : member.size));
    }
    return size;
}

class Reflector {
  public:
    explicit Reflector(const Spirv& module) : code_(instructions(module)) {
        for (const Instruction& i : code_) {
            declared_.read(i);
            if (i.opcode >= SpvOpConstantTrue && i.opcode <= SpvOpSpecConstant) constants_[i.word(2)] = i;
        }
    }

    ModuleInterface run() const {
        ModuleInterface all;
        for (const Instruction& i : code_) {
            if (i.opcode == SpvOpVariable) add_variable(i, all);
            if (i.opcode == SpvOpExecutionMode && i.word(2) == SpvExecutionModeLocalSize)
                all.local_size = {i.word(3), i.word(4), i.word(5)};
            if (i.opcode == SpvOpSpecConstantComposite &&
                declared_.decorations_of(i.word(2)).built_in == SpvBuiltInWorkgroupSize)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    all.local_size_ids.at(axis) = declared_.decorations_of(i.word(3 + axis)).spec_id;
        }
        for (const auto& [id, constant] : constants_)
            if (const auto number = declared_.decorations_of(id).spec_id)
                all.constants.push_back({.id = *number,
                                         .name = declared_.name_of(id),
                                         .type = scalar_name(type(constant.word(1))),
                                         .bits = bits_of(constant)});
        std::ranges::sort(all.constants, {}, &SpecializationConstant::id);
        std::ranges::stable_sort(all.bindings, {},
                                 [](const Binding& b) { return std::tuple(b.set, b.number, b.type); });
        return all;
    }

  private:
    const spirv::Type& type(Id id) const {
        const auto found = declared_.types.find(id);
        if (found == declared_.types.end())
            throw std::runtime_error("a type that is not known: ID " + std::to_string(id));
        return found->second;
    }

    static std::uint32_t bits_of(const Instruction& constant) {
        const bool is_true = constant.opcode == SpvOpConstantTrue || constant.opcode == SpvOpSpecConstantTrue;
        return is_true ? 1 : constant.word(3);
    }

    // The element of array `name` of any dimensions, and their sizes, outermost first: 0 of one without.
    Id element_of(Id id, const std::string& name, std::vector<unsigned>& sizes) const {
        for (; type(id).kind == Kind::array || type(id).kind == Kind::runtime_array; id = type(id).element) {
            const bool unbounded = type(id).kind == Kind::runtime_array;
            const auto size = constants_.find(type(id).length);
            if (!unbounded && size == constants_.end())
                throw std::runtime_error(
                    "array " + name +
                    ": its size is an expression on specialization constants, which is not supported");
            sizes.push_back(unbounded ? 0 : bits_of(size->second));
        }
        return id;
    }

    void add_variable(const Instruction& variable, ModuleInterface& all) const {
        const std::uint32_t storage = variable.word(3);
        constexpr std::array<std::uint32_t, 4> outside{SpvStorageClassUniformConstant, SpvStorageClassUniform,
                                                       SpvStorageClassStorageBuffer,
                                                       SpvStorageClassPushConstant};
        if (std::ranges::find(outside, storage) == outside.end()) return;
        std::vector<unsigned> sizes;
        const Id id = element_of(type(variable.word(1)).element, declared_.name_of(variable.word(2)), sizes);
        if (storage == SpvStorageClassPushConstant) all.push_constants = block(id);
        const auto kind = binding_type(storage, type(id));
        if (!kind) return;
        const spirv::Decorations decorations = declared_.decorations_of(variable.word(2));
        Binding binding{.set = decorations.set,
                        .number = decorations.binding,
                        .name = declared_.name_of(variable.word(2)),
                        .type = *kind};
        for (const unsigned size : sizes) binding.count *= std::max(1U, size);
        const bool stored = *kind == BindingType::storage_image;
        if (stored || *kind == BindingType::sampled_image) {
            const spirv::Type& image = stored ? type(id) : type(type(id).element);
            binding.texel = scalar_name(type(image.element));
            binding.shape = shape_of(image) + (sizes.empty() ? "" : "[]");
        }
        if (stored) binding.format = format_name(type(id).format);
        const bool buffer = *kind == BindingType::storage_buffer || *kind == BindingType::uniform_buffer;
        if (buffer) {
            binding.block = block(id);
            if (binding.name.empty()) binding.name = binding.block->name;
        }
        const auto all_have = [&](bool spirv::Member::* flag) {
            const std::vector<spirv::Member>& members = type(id).members;
            return buffer && std::ranges::all_of(members, flag);
        };
        binding.reads = !decorations.not_readable && !all_have(&spirv::Member::not_readable);
        binding.writes = (stored || *kind == BindingType::storage_buffer) && !decorations.not_writable &&
                         !all_have(&spirv::Member::not_writable);
        all.bindings.push_back(std::move(binding));
    }

    BlockLayout block(Id id) const {
        BlockLayout result{.name = declared_.name_of(id), .members = members(id)};
        result.size = size_of(result.members);
        return result;
    }

    std::vector<LaidOut> members(Id structure) const {
        std::vector<LaidOut> all;
        for (const spirv::Member& member : type(structure).members) all.push_back(laid_out(member));
        return all;
    }

    LaidOut laid_out(const spirv::Member& member) const {
        LaidOut result{.name = member.name,
                       .offset = member.offset,
                       .stride = type(member.type).array_stride,
                       .row_major = member.matrix.row_major};
        const Id id = element_of(member.type, member.name, result.sizes);
        if (type(id).kind == Kind::structure) {
            result.type = declared_.name_of(id);
            result.members = members(id);
            result.size = size_of(result.members);
        } else if (type(id).kind == Kind::pointer) {  // to a buffer, of 64 bits
            result.type = "uint";
            result.rows = 2;
            result.size = 8;
        } else {
            const spirv::Type* scalar = &type(id);
            if (scalar->kind == Kind::matrix) {
                result.columns = scalar->count;
                scalar = &type(scalar->element);
            }
            if (scalar->kind == Kind::vector) {
                result.rows = scalar->count;
                scalar = &type(scalar->element);
            }
            result.type = scalar_name(*scalar);
            result.size = std::size_t{4} * result.rows;
            if (result.columns > 1)
                result.size =
                    std::size_t{member.matrix.stride} * (result.row_major ? result.rows : result.columns);
        }
        if (!result.sizes.empty()) result.size = result.stride * std::max(1U, result.sizes.front());
        return result;
    }

    std::vector<Instruction> code_;
    spirv::Declarations declared_;
    std::map<Id, Instruction> constants_;
};

}  // namespace

ModuleInterface reflect(const Spirv& module) {
    return Reflector(module).run();
}

std::string to_string(BindingType type) {
    static constexpr std::array names{"storage image", "sampled image",  "texture",
                                      "sampler",       "storage buffer", "uniform buffer"};
    return names.at(static_cast<std::size_t>(type));
}

}  // namespace gloam::module
