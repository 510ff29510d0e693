// SPDX-License-Identifier: MIT
#include "shader/internal/round_trip.hpp"

#include <spirv_cross_c.h>

#include <stdexcept>

#include "shader/internal/cross_text.hpp"
#include "shader/internal/float_controls.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/storage_buffers.hpp"

namespace gloam::shader::internal {

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
