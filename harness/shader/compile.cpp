// SPDX-License-Identifier: MIT
#include "shader/compile.hpp"

#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.h>

#include "shader/decorate.hpp"
#include "shader/internal/compiler_process.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/round_trip.hpp"
#include "shader/internal/storage_buffers.hpp"
#include "shader/internal/version_line.hpp"
#include "shader/spirv.hpp"

namespace gloam::shader {
namespace {

// Applies the variant to the front end's module; each step produces a valid module.
Spirv varied(Spirv module, Stage stage, const std::string& name, const Variant& variant) {
    validate(module);
    if (variant.through != Variant::Through::none)
        module = internal::round_trip(module, stage, name, variant.through);
    const auto decorated = [&variant](Spirv words) {
        if (variant.strict) words = with_no_contraction(words);
        if (variant.relaxed) words = with_relaxed_precision(words);
        return words;
    };
    // Decorates before the optimizer, so that it cannot contract, and after it, for instructions that it has
    // created.
    module = decorated(std::move(module));
    if (variant.optimization != Optimization::none)
        module = decorated(optimize(module, variant.optimization));
    if (variant.through != Variant::Through::none || variant.strict || variant.relaxed ||
        variant.optimization != Optimization::none)
        validate(module);
    return module;
}

}  // namespace

Spirv internal::compile_here(const Source& source, const CompileOptions& options) {
    internal::require_vulkan_version(source);
    Spirv module = internal::to_spirv(source, options.stage, options.include_roots, {.lines = options.lines});
    try {
        return varied(std::move(module), options.stage, source.name, options.variant);
    } catch (const CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw CompileError(source.name + ": " + error.what());
    }
}

Spirv compile_hlsl(const Source& source, Stage stage) {
    try {
        Spirv module = internal::with_storage_buffers(internal::hlsl_to_spirv(source, stage));
        validate(module);
        return module;
    } catch (const CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw CompileError(source.name + ": " + error.what());
    }
}

std::string compiler_version() {
    const glslang::Version version = glslang::GetVersion();
    return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.patch) + version.flavor + " (generator " +
           std::to_string(glslang::GetSpirvGeneratorVersion()) + "), " + spvSoftwareVersionDetailsString() +
           ", " + internal::cross_version();
}

}  // namespace gloam::shader
