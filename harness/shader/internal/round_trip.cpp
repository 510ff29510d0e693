// SPDX-License-Identifier: MIT
#include "shader/internal/round_trip.hpp"

#include <spirv_cross_c.h>

#include <memory>
#include <stdexcept>

#include "shader/internal/float_controls.hpp"
#include "shader/internal/front_end.hpp"

namespace gloam::shader::internal {
namespace {

constexpr unsigned glsl_version = 450;

struct DestroyContext {
    void operator()(spvc_context context) const { spvc_context_destroy(context); }
};
// Owns all that is made from it.
using Context = std::unique_ptr<spvc_context_s, DestroyContext>;

Context make_context() {
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS) throw std::runtime_error("SPIRV-Cross: out of memory");
    return Context(context);
}

void require(const Context& context, spvc_result result) {
    if (result == SPVC_SUCCESS) return;
    throw std::runtime_error(std::string("SPIRV-Cross cannot write the module as GLSL: ") +
                             spvc_context_get_last_error_string(context.get()));
}

}  // namespace

std::string to_glsl(const Spirv& module) {
    const Context context = make_context();
    spvc_parsed_ir parsed = nullptr;
    require(context, spvc_context_parse_spirv(context.get(), module.data(), module.size(), &parsed));
    spvc_compiler compiler = nullptr;
    require(context, spvc_context_create_compiler(context.get(), SPVC_BACKEND_GLSL, parsed,
                                                  SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler));
    spvc_compiler_options options = nullptr;
    require(context, spvc_compiler_create_compiler_options(compiler, &options));
    require(context,
            spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, glsl_version));
    require(context,
            spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, SPVC_TRUE));
    require(context, spvc_compiler_install_compiler_options(compiler, options));
    const char* text = nullptr;
    require(context, spvc_compiler_compile(compiler, &text));
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
