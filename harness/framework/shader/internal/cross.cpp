// SPDX-License-Identifier: MIT
#include "shader/internal/cross.hpp"

#include <spirv.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "shader/internal/front_end.hpp"
#include "shader/spirv.hpp"

namespace gloam::shader::internal {

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

// A buffer without a name of its own gets that of its block, which HLSL has not.
void name_buffers(const Cross& cross) {
    for (const spvc_reflected_resource& buffer : resources_of(cross, SPVC_RESOURCE_TYPE_STORAGE_BUFFER)) {
        const std::string own = spvc_compiler_get_name(cross.compiler(), buffer.id);
        if (!own.empty()) continue;
        const std::string block = spvc_compiler_get_name(cross.compiler(), buffer.base_type_id);
        spvc_compiler_set_name(cross.compiler(), buffer.id, block.c_str());
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

namespace {

bool is_mode(const Instruction& i) {
    constexpr std::array modes{SpvExecutionModeDenormPreserve, SpvExecutionModeDenormFlushToZero,
                               SpvExecutionModeSignedZeroInfNanPreserve, SpvExecutionModeRoundingModeRTE,
                               SpvExecutionModeRoundingModeRTZ};
    return i.opcode == SpvOpExecutionMode && std::ranges::find(modes, i.word(2)) != modes.end();
}

bool is_capability(const Instruction& i) {
    constexpr std::array capabilities{SpvCapabilityDenormPreserve, SpvCapabilityDenormFlushToZero,
                                      SpvCapabilitySignedZeroInfNanPreserve, SpvCapabilityRoundingModeRTE,
                                      SpvCapabilityRoundingModeRTZ};
    return i.opcode == SpvOpCapability && std::ranges::find(capabilities, i.word(1)) != capabilities.end();
}

bool is_extension(const Instruction& i) {
    if (i.opcode != SpvOpExtension) return false;
    const std::span<const std::byte> bytes = std::as_bytes(i.words.subspan(1));
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    return std::string_view(text, strnlen(text, bytes.size())) == "SPV_KHR_float_controls";
}

std::uint32_t entry_point_of(const std::vector<Instruction>& instructions) {
    const auto found = std::ranges::find(instructions, std::uint32_t{SpvOpEntryPoint}, &Instruction::opcode);
    if (found == instructions.end()) throw std::runtime_error("SPIR-V module without an entry point");
    return found->word(2);
}

// The float controls of `original` that are missing in `present`, with their entry point replaced.
Spirv missing(const std::vector<Instruction>& original, const std::vector<Instruction>& present,
              std::uint32_t entry_point, const std::function<bool(const Instruction&)>& wanted) {
    Spirv result;
    for (const Instruction& i : original) {
        if (!wanted(i)) continue;
        Spirv words(i.words.begin(), i.words.end());
        if (i.opcode == SpvOpExecutionMode) words[1] = entry_point;
        const bool there = std::ranges::any_of(
            present, [&words](const Instruction& other) { return std::ranges::equal(other.words, words); });
        if (!there) result.insert(result.end(), words.begin(), words.end());
    }
    return result;
}

// Index behind the last instruction of one of these kinds.
std::size_t behind(const std::vector<Instruction>& instructions, std::initializer_list<SpvOp> kinds) {
    std::size_t at = 0;
    for (const Instruction& i : instructions)
        if (std::ranges::find(kinds, static_cast<SpvOp>(i.opcode)) != kinds.end()) at = i.at + i.words.size();
    return at;
}

}  // namespace

Spirv with_float_controls_of(const Spirv& original, const Spirv& module) {
    const std::vector<Instruction> from = instructions(original);
    const std::vector<Instruction> to = instructions(module);
    const std::uint32_t entry_point = entry_point_of(to);
    Spirv result = module;
    const auto insert = [&](std::initializer_list<SpvOp> kinds, auto wanted) {
        const Spirv words = missing(from, to, entry_point, wanted);
        result.insert(result.begin() + static_cast<std::ptrdiff_t>(behind(to, kinds)), words.begin(),
                      words.end());
    };
    // Inserts from the last section to the first, so that earlier indices stay valid.
    insert({SpvOpEntryPoint, SpvOpExecutionMode, SpvOpExecutionModeId}, is_mode);
    insert({SpvOpCapability, SpvOpExtension}, is_extension);
    insert({SpvOpCapability}, is_capability);
    return result;
}

Spirv with_storage_buffers(Spirv module) {
    // Words of an instruction, the first one included.
    constexpr std::size_t decorated = 1;
    constexpr std::size_t decoration = 2;
    constexpr std::size_t class_of_pointer = 2;
    constexpr std::size_t pointee = 3;
    constexpr std::size_t class_of_variable = 3;
    std::set<std::uint32_t> uniform_blocks;
    const Spirv before = module;
    for (const Instruction& i : instructions(before)) {
        const bool decorates = i.opcode == SpvOpDecorate;
        if (decorates && i.word(decoration) == SpvDecorationBufferBlock)
            module[i.at + decoration] = SpvDecorationBlock;
        if (decorates && i.word(decoration) == SpvDecorationBlock) uniform_blocks.insert(i.word(decorated));
        if (i.opcode == SpvOpTypePointer && i.word(class_of_pointer) == SpvStorageClassUniform) {
            if (uniform_blocks.contains(i.word(pointee)))
                throw std::runtime_error("uniform buffers beside storage buffers: expected push constants");
            module[i.at + class_of_pointer] = SpvStorageClassStorageBuffer;
        }
        if (i.opcode == SpvOpVariable && i.word(class_of_variable) == SpvStorageClassUniform)
            module[i.at + class_of_variable] = SpvStorageClassStorageBuffer;
    }
    return module;
}

Spirv translated_back(const Spirv& module, Stage stage, const std::string& name, bool hlsl) {
    try {
        const Source source{.name = name + (hlsl ? ", as HLSL" : ", as GLSL"),
                            .text = hlsl ? to_hlsl(module) : to_glsl(module)};
        return with_float_controls_of(module,
                                      hlsl ? with_storage_buffers(legalized(hlsl_to_spirv(source, stage)))
                                           : to_spirv(source, stage, {}));
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

namespace gloam::shader {

std::string opengl_text(const Spirv& module, Language language, unsigned push_constant_binding) {
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

}  // namespace gloam::shader
