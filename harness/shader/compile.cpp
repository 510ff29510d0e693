// SPDX-License-Identifier: MIT
#include "shader/compile.hpp"

#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.h>

#include "shader/internal/front_end.hpp"
#include "shader/internal/version_line.hpp"
#include "shader/spirv.hpp"

namespace gloam::shader {
namespace {

Spirv generate(const glslang::TIntermediate& tree, const std::string& name) {
    Spirv module;
    spv::SpvBuildLogger logger;
    glslang::SpvOptions options;
    options.disableOptimizer = true;  // ours runs after it, with the passes that the caller chose
    glslang::GlslangToSpv(tree, module, &logger, &options);
    const std::string messages = logger.getAllMessages();
    for (const char* failure : {"error: ", "Missing functionality: "})
        if (messages.find(failure) != std::string::npos) throw CompileError(name + ": " + messages);
    return module;
}

}  // namespace

Spirv compile(const Source& source, const CompileOptions& options) {
    internal::require_vulkan_version(source);
    internal::Parse parse(options.stage, internal::Client::vulkan, source.name, {source},
                          options.include_roots);
    const Spirv module = generate(parse.link(), source.name);
    try {
        validate(module);
        if (options.optimization == Optimization::none) return module;
        Spirv optimized = optimize(module, options.optimization);
        validate(optimized);
        return optimized;
    } catch (const std::runtime_error& error) {
        throw CompileError(source.name + ": " + error.what());
    }
}

std::string compiler_version() {
    const glslang::Version version = glslang::GetVersion();
    return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.patch) + version.flavor + " (generator " +
           std::to_string(glslang::GetSpirvGeneratorVersion()) + "), " + spvSoftwareVersionDetailsString();
}

}  // namespace gloam::shader
