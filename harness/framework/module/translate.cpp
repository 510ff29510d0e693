// SPDX-License-Identifier: MIT
#include <spirv.h>
#include <spirv_cross_c.h>
#include <algorithm>
#include <initializer_list>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "module/internal/front_end.hpp"
#include "module/spirv.hpp"
#include "module/texts.hpp"
#include "source/declarations.hpp"

// Modules as texts of other languages, as SPIRV-Cross writes them; names are kept.
namespace gloam::module {
namespace {

// SPIRV-Cross on one module. Pointers from it are valid as long as this object.
class Cross {
  public:
    // `purpose`, for messages: "write the module as GLSL". Throws std::runtime_error.
    Cross(const Spirv& module, spvc_backend backend, std::string purpose) : purpose_(std::move(purpose)) {
        spvc_context context = nullptr;
        if (spvc_context_create(&context) != SPVC_SUCCESS)
            throw std::runtime_error("SPIRV-Cross: out of memory");
        context_.reset(context);
        spvc_parsed_ir parsed = nullptr;
        require(spvc_context_parse_spirv(context, module.data(), module.size(), &parsed));
        require(spvc_context_create_compiler(context, backend, parsed, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                             &compiler_));
    }

    [[nodiscard]] spvc_compiler compiler() const { return compiler_; }

    // Throws std::runtime_error unless the call has succeeded.
    void require(spvc_result result) const {
        if (result == SPVC_SUCCESS) return;
        throw std::runtime_error("SPIRV-Cross cannot " + purpose_ + ": " +
                                 spvc_context_get_last_error_string(context_.get()));
    }

    [[nodiscard]] std::span<const spvc_reflected_resource> list(spvc_resources resources,
                                                                spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        require(spvc_resources_get_resource_list_for_type(resources, type, &first, &count));
        return {first, count};
    }

  private:
    struct Destroy {
        void operator()(spvc_context context) const { spvc_context_destroy(context); }
    };
    std::string purpose_;
    std::unique_ptr<spvc_context_s, Destroy> context_;
    spvc_compiler compiler_ = nullptr;
};

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
unsigned next_binding(const Cross& cross, std::initializer_list<spvc_resource_type> types) {
    unsigned next = 0;
    for (const spvc_resource_type type : types)
        for (const spvc_reflected_resource& each : resources_of(cross, type))
            next = std::max(
                next, spvc_compiler_get_decoration(cross.compiler(), each.id, SpvDecorationBinding) + 1);
    return next;
}

// The module's text. The value of a switch is 1: on.
std::string text_of(const Cross& cross,
                    std::initializer_list<std::pair<spvc_compiler_option, unsigned>> settings) {
    spvc_compiler_options options = nullptr;
    cross.require(spvc_compiler_create_compiler_options(cross.compiler(), &options));
    for (const auto& [option, value] : settings)
        cross.require(spvc_compiler_options_set_uint(options, option, value));
    cross.require(spvc_compiler_install_compiler_options(cross.compiler(), options));
    const char* text = nullptr;
    cross.require(spvc_compiler_compile(cross.compiler(), &text));
    return text;
}

// HLSL of shader model 6.0 for Direct3D. The number of a register is that of the binding: b for uniform
// buffers, t for what is only read, u for what is written, s for samplers. Push constants are the constant
// buffer after the last one. Throws std::runtime_error with SPIRV-Cross's message.
std::string to_hlsl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_HLSL, "write the module as HLSL");
    name_buffers(cross);
    spvc_hlsl_resource_binding push_constants;
    spvc_hlsl_resource_binding_init(&push_constants);
    push_constants.stage = spvc_compiler_get_execution_model(cross.compiler());
    push_constants.desc_set = SPVC_HLSL_PUSH_CONSTANT_DESC_SET;
    push_constants.binding = SPVC_HLSL_PUSH_CONSTANT_BINDING;
    push_constants.cbv.register_binding = next_binding(cross, {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER});
    cross.require(spvc_compiler_hlsl_add_resource_binding(cross.compiler(), &push_constants));
    return text_of(cross, {{SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, hlsl_shader_model},
                           {SPVC_COMPILER_OPTION_HLSL_NONWRITABLE_UAV_TEXTURE_AS_SRV, 1}});
}

// Metal Shading Language 2.1. The number of a buffer, texture or sampler is that of the binding; push
// constants are the buffer after the last binding. Throws std::runtime_error with SPIRV-Cross's message.
std::string to_msl(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_MSL, "write the module as MSL");
    spvc_msl_resource_binding push_constants;
    spvc_msl_resource_binding_init(&push_constants);
    push_constants.stage = spvc_compiler_get_execution_model(cross.compiler());
    push_constants.desc_set = SPVC_MSL_PUSH_CONSTANT_DESC_SET;
    push_constants.binding = SPVC_MSL_PUSH_CONSTANT_BINDING;
    push_constants.msl_buffer =
        next_binding(cross, {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER});
    cross.require(spvc_compiler_msl_add_resource_binding(cross.compiler(), &push_constants));
    return text_of(cross, {{SPVC_COMPILER_OPTION_MSL_VERSION, SPVC_MAKE_MSL_VERSION(2, 1, 0)},
                           {SPVC_COMPILER_OPTION_MSL_ENABLE_DECORATION_BINDING, 1}});
}

void require_values(const std::string& name, const source::FunctionHead& function) {
    for (const source::DeclaredParameter& parameter : function.parameters)
        if (source::is_opaque(parameter.type))
            throw std::invalid_argument(name + ": " + function.name + " has a parameter of type " +
                                        parameter.type +
                                        ": functions with images as parameters are not translated");
}

// A main() that calls every function once: SPIRV-Cross writes what main() reaches.
std::string caller_of(const std::vector<source::FunctionHead>& functions) {
    std::string variables;
    std::string calls;
    std::size_t count = 0;
    for (const source::FunctionHead& function : functions) {
        std::string arguments;
        for (const source::DeclaredParameter& parameter : function.parameters) {
            const std::string name = "argument" + std::to_string(count++);
            variables += parameter.type + " " + name + ";\n";
            arguments += (arguments.empty() ? "" : ", ") + name;
        }
        calls += function.name + "(" + arguments + ");\n";
    }
    return "\nvoid main() {\n" + variables + calls + "}\n";
}

// The text with a main(), and with bodies of the functions that its user defines.
std::string whole(const source::Source& packed, source::Stage stage) {
    std::vector<source::FunctionHead> functions = source::function_heads(internal::preprocessed(
        {packed}, stage, internal::Client::vulkan, internal::include_folders({}, {packed})));
    if (std::ranges::find(functions, "main", &source::FunctionHead::name) != functions.end())
        return packed.text;
    for (const source::FunctionHead& function : functions) require_values(packed.name, function);
    const std::string text = packed.text + caller_of(functions);
    functions.push_back({.name = "main", .result = "void", .text = "", .parameters = {}, .defined = true});
    return source::completed(text, functions);
}

std::string licences_of(const std::string& text) {
    std::istringstream lines(text);
    std::string licences;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("//") && line.find("SPDX-License-Identifier") != std::string::npos)
            licences += line + "\n";
    return licences;
}

}  // namespace

std::optional<Target> target_from(std::string_view name) {
    if (name == "hlsl") return Target::hlsl;
    if (name == "msl") return Target::msl;
    return std::nullopt;
}

std::string suffix(Target target) {
    return target == Target::hlsl ? ".hlsl" : ".metal";
}

std::string translated(const source::Source& packed, Target target, source::Stage stage) {
    const bool hlsl = target == Target::hlsl;
    const char* head =
        hlsl ? "// HLSL of shader model 6.0 by SPIRV-Cross. Compile it by IEEE's rules (dxc -Gis).\n"
             : "// Metal Shading Language 2.1 by SPIRV-Cross. Compile it without fast math.\n";
    try {
        const Spirv module = internal::to_spirv({packed.name, whole(packed, stage)}, stage, {});
        return licences_of(packed.text) + head + (hlsl ? to_hlsl(module) : to_msl(module));
    } catch (const source::CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(packed.name + ": " + error.what());
    }
}

std::vector<Resource> used_resources(const Spirv& module) {
    const Cross cross(module, SPVC_BACKEND_NONE, "read the module");
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
    const Cross cross(module, SPVC_BACKEND_GLSL, "write the module as GLSL for OpenGL");
    const std::string version = to_string(language);  // "310es"
    for (const spvc_reflected_resource& each : resources_of(cross, SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
        spvc_compiler_set_decoration(cross.compiler(), each.id, SpvDecorationBinding, push_constant_binding);
    return text_of(cross, {{SPVC_COMPILER_OPTION_GLSL_VERSION, static_cast<unsigned>(std::stoul(version))},
                           {SPVC_COMPILER_OPTION_GLSL_ES, version.ends_with("es") ? 1U : 0U},
                           {SPVC_COMPILER_OPTION_GLSL_EMIT_PUSH_CONSTANT_AS_UNIFORM_BUFFER, 1}});
}

}  // namespace gloam::module
