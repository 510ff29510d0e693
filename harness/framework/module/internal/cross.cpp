// SPDX-License-Identifier: MIT
#include "module/internal/cross.hpp"

#include <spirv.h>
#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "module/spirv.hpp"

namespace gloam::module::internal {

Cross::Cross(const Spirv& module, spvc_backend backend, std::string purpose) : purpose_(std::move(purpose)) {
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS) throw std::runtime_error("SPIRV-Cross: out of memory");
    context_.reset(context);
    spvc_parsed_ir parsed = nullptr;
    require(spvc_context_parse_spirv(context, module.data(), module.size(), &parsed));
    require(
        spvc_context_create_compiler(context, backend, parsed, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_));
}

void Cross::require(spvc_result result) const {
    if (result == SPVC_SUCCESS) return;
    throw std::runtime_error("SPIRV-Cross cannot " + purpose_ + ": " +
                             spvc_context_get_last_error_string(context_.get()));
}

std::span<const spvc_reflected_resource> Cross::list(spvc_resources resources,
                                                     spvc_resource_type type) const {
    const spvc_reflected_resource* first = nullptr;
    std::size_t count = 0;
    require(spvc_resources_get_resource_list_for_type(resources, type, &first, &count));
    return {first, count};
}

namespace {

constexpr unsigned hlsl_shader_model = 60;

std::span<const spvc_reflected_resource> resources_of(const Cross& cross, spvc_resource_type type) {
    spvc_resources resources = nullptr;
    cross.require(spvc_compiler_create_shader_resources(cross.compiler(), &resources));
    return cross.list(resources, type);
}

// A buffer without a name of its own gets that of its block, which HLSL has not.
void name_buffers(const Cross& cross) {
    for (const spvc_reflected_resource& buffer : resources_of(cross, SPVC_RESOURCE_TYPE_STORAGE_BUFFER)) {
        const std::string own = spvc_compiler_get_name(cross.compiler(), buffer.id);
        if (!own.empty()) continue;
        const std::string block = spvc_compiler_get_name(cross.compiler(), buffer.base_type_id);
        spvc_compiler_set_name(cross.compiler(), buffer.id, block.c_str());
    }
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

std::string to_msl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_MSL, "write the module as MSL");
    const spvc_compiler_options options = options_of(cross);
    set(cross, options, SPVC_COMPILER_OPTION_MSL_VERSION, SPVC_MAKE_MSL_VERSION(2, 1, 0));
    enable(cross, options, SPVC_COMPILER_OPTION_MSL_ENABLE_DECORATION_BINDING);
    constexpr std::array buffers{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER};
    spvc_msl_resource_binding push_constants;
    spvc_msl_resource_binding_init(&push_constants);
    push_constants.stage = spvc_compiler_get_execution_model(cross.compiler());
    push_constants.desc_set = SPVC_MSL_PUSH_CONSTANT_DESC_SET;
    push_constants.binding = SPVC_MSL_PUSH_CONSTANT_BINDING;
    push_constants.msl_buffer = next_binding(cross, buffers);
    cross.require(spvc_compiler_msl_add_resource_binding(cross.compiler(), &push_constants));
    return text_of(cross, options);
}

std::string cross_version() {
    unsigned major = 0;
    unsigned minor = 0;
    unsigned patch = 0;
    spvc_get_version(&major, &minor, &patch);
    const char* commit = spvc_get_commit_revision_and_timestamp();
    return "SPIRV-Cross " + std::to_string(major) + "." + std::to_string(minor) + "." +
           std::to_string(patch) + (commit != nullptr && *commit != '\0' ? std::string(" ") + commit : "");
}

}  // namespace gloam::module::internal

namespace gloam::module {

std::vector<Resource> used_resources(const Spirv& module) {
    const internal::Cross cross(module, SPVC_BACKEND_NONE, "read the module");
    spvc_set active = nullptr;
    cross.require(spvc_compiler_get_active_interface_variables(cross.compiler(), &active));
    spvc_resources all = nullptr;
    cross.require(spvc_compiler_create_shader_resources_for_active_variables(cross.compiler(), &all, active));
    std::vector<Resource> resources;
    for (const auto& [type, kind] : {std::pair(SPVC_RESOURCE_TYPE_STORAGE_IMAGE, "image or sampler"),
                                     std::pair(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, "image or sampler"),
                                     std::pair(SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, "image or sampler"),
                                     std::pair(SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, "image or sampler"),
                                     std::pair(SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, "uniform buffer"),
                                     std::pair(SPVC_RESOURCE_TYPE_STORAGE_BUFFER, "storage buffer"),
                                     std::pair(SPVC_RESOURCE_TYPE_PUSH_CONSTANT, "push constants")})
        for (const spvc_reflected_resource& each : cross.list(all, type))
            resources.push_back({kind, spvc_compiler_get_name(cross.compiler(), each.id),
                                 spvc_compiler_get_name(cross.compiler(), each.base_type_id)});
    return resources;
}

std::string opengl_text(const Spirv& module, source::Language language, unsigned push_constant_binding) {
    const internal::Cross cross(module, SPVC_BACKEND_GLSL, "write the module as GLSL for OpenGL");
    const spvc_compiler_options options = internal::options_of(cross);
    const std::string version = to_string(language);  // "310es"
    internal::set(cross, options, SPVC_COMPILER_OPTION_GLSL_VERSION,
                  static_cast<unsigned>(std::stoul(version)));
    if (version.ends_with("es")) internal::enable(cross, options, SPVC_COMPILER_OPTION_GLSL_ES);
    internal::enable(cross, options, SPVC_COMPILER_OPTION_GLSL_EMIT_PUSH_CONSTANT_AS_UNIFORM_BUFFER);
    for (const spvc_reflected_resource& each :
         internal::resources_of(cross, SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
        spvc_compiler_set_decoration(cross.compiler(), each.id, SpvDecorationBinding, push_constant_binding);
    return internal::text_of(cross, options);
}

}  // namespace gloam::module
