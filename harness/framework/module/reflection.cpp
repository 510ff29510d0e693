// SPDX-License-Identifier: MIT
#include "module/reflection.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <tuple>

#include "module/internal/cross.hpp"

namespace gloam::module {
namespace {

std::string name_of(spvc_basetype type) {
    static const std::map<spvc_basetype, const char*> names{{SPVC_BASETYPE_BOOLEAN, "bool"},
                                                            {SPVC_BASETYPE_INT32, "int"},
                                                            {SPVC_BASETYPE_UINT32, "uint"},
                                                            {SPVC_BASETYPE_FP32, "float"}};
    if (const auto found = names.find(type); found != names.end()) return found->second;
    throw std::runtime_error("a member that is no float, int, uint, bool or structure of them");
}

std::string format_name(SpvImageFormat format) {
    static const std::map<SpvImageFormat, std::string> names{
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

class Reflector {
  public:
    explicit Reflector(const Spirv& module)
        : cross_(module, SPVC_BACKEND_NONE, "reflect the module"), compiler_(cross_.compiler()) {
        cross_.require(spvc_compiler_create_shader_resources(compiler_, &resources_));
    }

    ModuleInterface run() {
        using enum BindingType;
        ModuleInterface all;
        for (const auto& [kind, type] : {std::pair(SPVC_RESOURCE_TYPE_STORAGE_IMAGE, storage_image),
                                         std::pair(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, sampled_image),
                                         std::pair(SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, texture),
                                         std::pair(SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, sampler),
                                         std::pair(SPVC_RESOURCE_TYPE_STORAGE_BUFFER, storage_buffer),
                                         std::pair(SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, uniform_buffer)}) {
            for (const spvc_reflected_resource& resource : cross_.list(resources_, kind))
                all.bindings.push_back(binding(resource, type));
        }
        std::ranges::sort(all.bindings, {}, [](const Binding& b) { return std::tuple(b.set, b.number); });
        for (const spvc_reflected_resource& resource :
             cross_.list(resources_, SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
            all.push_constants = block(resource);
        all.constants = constants();
        for (unsigned axis = 0; axis < 3; ++axis)
            all.local_size.at(axis) = spvc_compiler_get_execution_mode_argument_by_index(
                compiler_, SpvExecutionModeLocalSize, axis);
        std::array<spvc_specialization_constant, 3> sizes{};
        (void)spvc_compiler_get_work_group_size_specialization_constants(compiler_, &sizes[0], &sizes[1],
                                                                         &sizes[2]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (sizes.at(axis).id != 0) all.local_size_ids.at(axis) = sizes.at(axis).constant_id;
        return all;
    }

  private:
    std::string shape_of(const spvc_reflected_resource& resource) const {
        const spvc_type image = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
        static const std::map<SpvDim, std::string> names{
            {SpvDim1D, "1D"}, {SpvDim2D, "2D"}, {SpvDim3D, "3D"}, {SpvDimCube, "Cube"}};
        const auto found = names.find(spvc_type_get_image_dimension(image));
        std::string shape = found == names.end() ? "Buffer" : found->second;
        if (spvc_type_get_image_multisampled(image) != SPVC_FALSE) shape += "MS";
        if (spvc_type_get_image_arrayed(image) != SPVC_FALSE) shape += "Array";
        if (spvc_type_get_image_is_depth(image) != SPVC_FALSE) shape += "Shadow";
        const spvc_type whole = spvc_compiler_get_type_handle(compiler_, resource.type_id);
        return spvc_type_get_num_array_dimensions(whole) > 0 ? shape + "[]" : shape;
    }

    // Of an array without a size 1.
    std::uint32_t count_of(const spvc_reflected_resource& resource) const {
        const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.type_id);
        std::uint32_t count = 1;
        for (unsigned d = 0; d < spvc_type_get_num_array_dimensions(type); ++d)
            count *= std::max(1U, spvc_type_get_array_dimension(type, d));
        return count;
    }

    Binding binding(const spvc_reflected_resource& resource, BindingType type) const {
        Binding result{.set = decoration(resource.id, SpvDecorationDescriptorSet),
                       .number = decoration(resource.id, SpvDecorationBinding),
                       .count = count_of(resource),
                       .name = spvc_compiler_get_name(compiler_, resource.id),
                       .type = type};
        const auto has = [&](SpvDecoration d) {
            return spvc_compiler_has_decoration(compiler_, resource.id, d) != SPVC_FALSE;
        };
        if (type == BindingType::storage_image || type == BindingType::sampled_image) {
            const spvc_type image = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
            const spvc_type_id texel = spvc_type_get_image_sampled_type(image);
            result.texel = name_of(spvc_type_get_basetype(spvc_compiler_get_type_handle(compiler_, texel)));
            result.shape = shape_of(resource);
        }
        if (type == BindingType::storage_image) {
            const spvc_type image = spvc_compiler_get_type_handle(compiler_, resource.type_id);
            result.format = format_name(spvc_type_get_image_storage_format(image));
            result.reads = !has(SpvDecorationNonReadable);
            result.writes = !has(SpvDecorationNonWritable);
        } else if (type == BindingType::storage_buffer || type == BindingType::uniform_buffer) {
            result.block = block(resource);
            const std::vector<SpvDecoration> of_all = buffer_decorations(resource.id);
            const auto all_have = [&](SpvDecoration d) {
                return std::ranges::find(of_all, d) != of_all.end();
            };
            result.reads = !all_have(SpvDecorationNonReadable);
            result.writes = type == BindingType::storage_buffer && !all_have(SpvDecorationNonWritable);
            if (result.name.empty()) result.name = result.block->name;
        }
        return result;
    }

    std::vector<SpvDecoration> buffer_decorations(spvc_variable_id id) const {
        const SpvDecoration* first = nullptr;
        std::size_t count = 0;
        cross_.require(spvc_compiler_get_buffer_block_decorations(compiler_, id, &first, &count));
        return {first, first + count};
    }

    std::uint32_t decoration(SpvId id, SpvDecoration which) const {
        return spvc_compiler_get_decoration(compiler_, id, which);
    }

    BlockLayout block(const spvc_reflected_resource& resource) const {
        const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
        BlockLayout result{.name = spvc_compiler_get_name(compiler_, resource.base_type_id),
                           .members = members(type)};
        cross_.require(spvc_compiler_get_declared_struct_size(compiler_, type, &result.size));
        return result;
    }

    std::vector<LaidOut> members(spvc_type structure) const {
        std::vector<LaidOut> all;
        for (unsigned i = 0; i < spvc_type_get_num_member_types(structure); ++i)
            all.push_back(member(structure, i));
        return all;
    }

    LaidOut member(spvc_type structure, unsigned index) const {
        const spvc_type_id parent = spvc_type_get_base_type_id(structure);
        const spvc_type type =
            spvc_compiler_get_type_handle(compiler_, spvc_type_get_member_type(structure, index));
        LaidOut result{.name = spvc_compiler_get_member_name(compiler_, parent, index)};
        unsigned offset = 0;
        cross_.require(spvc_compiler_type_struct_member_offset(compiler_, structure, index, &offset));
        result.offset = offset;
        result.rows = spvc_type_get_vector_size(type);
        result.columns = spvc_type_get_columns(type);
        result.row_major = spvc_compiler_has_member_decoration(compiler_, parent, index,
                                                               SpvDecorationRowMajor) != SPVC_FALSE;
        // SPIRV-Cross has the innermost first.
        for (unsigned d = spvc_type_get_num_array_dimensions(type); d-- > 0;)
            result.sizes.push_back(spvc_type_get_array_dimension(type, d));
        if (!result.sizes.empty()) {
            unsigned stride = 0;
            cross_.require(
                spvc_compiler_type_struct_member_array_stride(compiler_, structure, index, &stride));
            result.stride = stride;
        }
        if (spvc_type_get_basetype(type) == SPVC_BASETYPE_STRUCT) {
            result.type = spvc_compiler_get_name(compiler_, spvc_type_get_base_type_id(type));
            result.members =
                members(spvc_compiler_get_type_handle(compiler_, spvc_type_get_base_type_id(type)));
        } else {
            result.type = name_of(spvc_type_get_basetype(type));
        }
        result.size = size_of(structure, index, type, result);
        return result;
    }

    std::size_t size_of(spvc_type structure, unsigned index, spvc_type type, const LaidOut& member) const {
        if (!member.sizes.empty()) return member.stride * std::max(1U, member.sizes.front());
        if (!member.members.empty()) {
            std::size_t size = 0;
            cross_.require(spvc_compiler_get_declared_struct_size(compiler_, type, &size));
            return size;
        }
        if (member.columns == 1) return std::size_t{4} * member.rows;
        unsigned stride = 0;
        cross_.require(spvc_compiler_type_struct_member_matrix_stride(compiler_, structure, index, &stride));
        return std::size_t{stride} * (member.row_major ? member.rows : member.columns);
    }

    std::vector<SpecializationConstant> constants() const {
        const spvc_specialization_constant* first = nullptr;
        std::size_t count = 0;
        cross_.require(spvc_compiler_get_specialization_constants(compiler_, &first, &count));
        std::vector<SpecializationConstant> all;
        for (const spvc_specialization_constant& constant : std::span(first, count)) {
            const spvc_constant value = spvc_compiler_get_constant_handle(compiler_, constant.id);
            const spvc_type type = spvc_compiler_get_type_handle(compiler_, spvc_constant_get_type(value));
            all.push_back({.id = constant.constant_id,
                           .name = spvc_compiler_get_name(compiler_, constant.id),
                           .type = name_of(spvc_type_get_basetype(type)),
                           .bits = spvc_constant_get_scalar_u32(value, 0, 0)});
        }
        std::ranges::sort(all, {}, &SpecializationConstant::id);
        return all;
    }

    internal::Cross cross_;
    spvc_compiler compiler_;
    spvc_resources resources_ = nullptr;
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
