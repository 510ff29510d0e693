// SPDX-License-Identifier: MIT
#include "shader/internal/round_trip.hpp"

#include <stdexcept>

#include "shader/internal/cross.hpp"
#include "shader/internal/float_controls.hpp"
#include "shader/internal/front_end.hpp"

namespace gloam::shader::internal {
namespace {

constexpr unsigned glsl_version = 450;

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

Spirv round_trip(const Spirv& module, Stage stage, const std::string& name) {
    try {
        const Source source{.name = name + ", round trip through SPIRV-Cross", .text = to_glsl(module)};
        return with_float_controls_of(module, to_spirv(source, stage, {}));
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
