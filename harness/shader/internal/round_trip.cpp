// SPDX-License-Identifier: MIT
#include "shader/internal/round_trip.hpp"

#include <span>
#include <stdexcept>

#include "shader/internal/cross.hpp"
#include "shader/internal/float_controls.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/storage_buffers.hpp"

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

// HLSL has no blocks for storage buffers: a buffer without a name of its own gets that of its block.
void name_buffers(const Cross& cross) {
    for (const spvc_reflected_resource& buffer : resources_of(cross, SPVC_RESOURCE_TYPE_STORAGE_BUFFER)) {
        const std::string own = spvc_compiler_get_name(cross.compiler(), buffer.id);
        if (own.empty())
            spvc_compiler_set_name(cross.compiler(), buffer.id,
                                   spvc_compiler_get_name(cross.compiler(), buffer.base_type_id));
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

}  // namespace

std::string to_glsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_GLSL, "write the module as GLSL");
    spvc_compiler_options options = nullptr;
    cross.require(spvc_compiler_create_compiler_options(cross.compiler(), &options));
    cross.require(spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, glsl_version));
    cross.require(
        spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, SPVC_TRUE));
    cross.require(spvc_compiler_install_compiler_options(cross.compiler(), options));
    const char* text = nullptr;
    cross.require(spvc_compiler_compile(cross.compiler(), &text));
    return text;
}

std::string to_hlsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_HLSL, "write the module as HLSL");
    spvc_compiler_options options = nullptr;
    cross.require(spvc_compiler_create_compiler_options(cross.compiler(), &options));
    cross.require(
        spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, hlsl_shader_model));
    cross.require(spvc_compiler_install_compiler_options(cross.compiler(), options));
    name_buffers(cross);
    const char* text = nullptr;
    cross.require(spvc_compiler_compile(cross.compiler(), &text));
    return with_push_constants(text, cross);
}

Spirv round_trip(const Spirv& module, Stage stage, const std::string& name, Variant::Through through) {
    const bool hlsl = through == Variant::Through::hlsl;
    try {
        const Source source{.name = name + (hlsl ? ", as HLSL" : ", round trip through SPIRV-Cross"),
                            .text = hlsl ? to_hlsl(module) : to_glsl(module)};
        return with_float_controls_of(
            module, hlsl ? with_storage_buffers(hlsl_to_spirv(source, stage)) : to_spirv(source, stage, {}));
    } catch (const CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw CompileError(name + ": " + error.what());
    }
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

}  // namespace gloam::shader::internal
