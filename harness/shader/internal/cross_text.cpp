// SPDX-License-Identifier: MIT
#include "shader/internal/cross_text.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "shader/internal/cross.hpp"

namespace gloam::shader::internal {
namespace {

constexpr unsigned glsl_version = 450;
constexpr unsigned hlsl_shader_model = 60;

std::span<const spvc_reflected_resource> resources_of(const Cross& cross, spvc_resource_type type) {
    spvc_resources resources = nullptr;
    cross.require(spvc_compiler_create_shader_resources(cross.compiler(), &resources));
    const spvc_reflected_resource* first = nullptr;
    std::size_t count = 0;
    cross.require(spvc_resources_get_resource_list_for_type(resources, type, &first, &count));
    return {first, count};
}

// "TileLists" as "tile_lists".
std::string in_snake_case(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool upper = c >= 'A' && c <= 'Z';
        if (upper && !result.empty()) result += '_';
        result += upper ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

// A buffer without a name of its own gets that of its block, which HLSL has not. In MSL it is a variable
// beside the block's type.
void name_buffers(const Cross& cross, bool beside_type = false) {
    for (const spvc_reflected_resource& buffer : resources_of(cross, SPVC_RESOURCE_TYPE_STORAGE_BUFFER)) {
        const std::string own = spvc_compiler_get_name(cross.compiler(), buffer.id);
        if (!own.empty()) continue;
        const std::string block = spvc_compiler_get_name(cross.compiler(), buffer.base_type_id);
        spvc_compiler_set_name(cross.compiler(), buffer.id,
                               (beside_type ? in_snake_case(block) : block).c_str());
    }
}

// SPIRV-Cross writes push constants as a cbuffer like any other.
std::string with_push_constants(std::string text, const Cross& cross) {
    for (const spvc_reflected_resource& each : resources_of(cross, SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
        const std::string block =
            std::string("cbuffer ") + spvc_compiler_get_name(cross.compiler(), each.base_type_id) + "\n";
        const std::size_t at = text.find(block);
        if (at == std::string::npos) throw std::runtime_error("push constants: no " + block + " in the HLSL");
        text.insert(at, "[[vk::push_constant]] ");
    }
    return text;
}

// The first number that no binding of these types has.
unsigned next_binding(const Cross& cross, std::span<const spvc_resource_type> types) {
    unsigned next = 0;
    for (const spvc_resource_type type : types)
        for (const spvc_reflected_resource& each : resources_of(cross, type))
            next = std::max(
                next, spvc_compiler_get_decoration(cross.compiler(), each.id, SpvDecorationBinding) + 1);
    return next;
}

spvc_compiler_options options_of(const Cross& cross) {
    spvc_compiler_options options = nullptr;
    cross.require(spvc_compiler_create_compiler_options(cross.compiler(), &options));
    return options;
}

std::string text_of(const Cross& cross, spvc_compiler_options options) {
    cross.require(spvc_compiler_install_compiler_options(cross.compiler(), options));
    const char* text = nullptr;
    cross.require(spvc_compiler_compile(cross.compiler(), &text));
    return text;
}

void set(const Cross& cross, spvc_compiler_options options, spvc_compiler_option option, unsigned value) {
    cross.require(spvc_compiler_options_set_uint(options, option, value));
}

void enable(const Cross& cross, spvc_compiler_options options, spvc_compiler_option option) {
    cross.require(spvc_compiler_options_set_bool(options, option, SPVC_TRUE));
}

}  // namespace

std::string to_glsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_GLSL, "write the module as GLSL");
    const spvc_compiler_options options = options_of(cross);
    set(cross, options, SPVC_COMPILER_OPTION_GLSL_VERSION, glsl_version);
    enable(cross, options, SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS);
    return text_of(cross, options);
}

std::string to_hlsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_HLSL, "write the module as HLSL");
    const spvc_compiler_options options = options_of(cross);
    set(cross, options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, hlsl_shader_model);
    name_buffers(cross);
    return with_push_constants(text_of(cross, options), cross);
}

std::string to_direct3d_hlsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_HLSL, "write the module as HLSL");
    const spvc_compiler_options options = options_of(cross);
    set(cross, options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, hlsl_shader_model);
    enable(cross, options, SPVC_COMPILER_OPTION_HLSL_NONWRITABLE_UAV_TEXTURE_AS_SRV);
    name_buffers(cross);
    constexpr std::array uniform{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER};
    spvc_hlsl_resource_binding push_constants;
    spvc_hlsl_resource_binding_init(&push_constants);
    push_constants.stage = spvc_compiler_get_execution_model(cross.compiler());
    push_constants.desc_set = SPVC_HLSL_PUSH_CONSTANT_DESC_SET;
    push_constants.binding = SPVC_HLSL_PUSH_CONSTANT_BINDING;
    push_constants.cbv.register_binding = next_binding(cross, uniform);
    cross.require(spvc_compiler_hlsl_add_resource_binding(cross.compiler(), &push_constants));
    return text_of(cross, options);
}

std::string to_msl(const Spirv& module, const std::string& entry) {
    const Cross cross(module, SPVC_BACKEND_MSL, "write the module as MSL");
    const spvc_compiler_options options = options_of(cross);
    set(cross, options, SPVC_COMPILER_OPTION_MSL_VERSION, SPVC_MAKE_MSL_VERSION(2, 1, 0));
    enable(cross, options, SPVC_COMPILER_OPTION_MSL_ENABLE_DECORATION_BINDING);
    name_buffers(cross, true);
    const SpvExecutionModel stage = spvc_compiler_get_execution_model(cross.compiler());
    cross.require(spvc_compiler_rename_entry_point(cross.compiler(), "main", entry.c_str(), stage));
    constexpr std::array buffers{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER};
    spvc_msl_resource_binding push_constants;
    spvc_msl_resource_binding_init(&push_constants);
    push_constants.stage = stage;
    push_constants.desc_set = SPVC_MSL_PUSH_CONSTANT_DESC_SET;
    push_constants.binding = SPVC_MSL_PUSH_CONSTANT_BINDING;
    push_constants.msl_buffer = next_binding(cross, buffers);
    cross.require(spvc_compiler_msl_add_resource_binding(cross.compiler(), &push_constants));
    return text_of(cross, options);
}

}  // namespace gloam::shader::internal
