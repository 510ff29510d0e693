// SPDX-License-Identifier: MIT
#include "effect/method_functions.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace gloam::effect {
namespace {

std::string text_for(const MethodInfo& method, int layers, float farthest) {
    const char* no_layers =
        layers > 1 ? "" : "vec3 gloam_fetch_layers(ivec2 pixel) {\n    return vec3(0.0);\n}\n";
    return fmt::format(
        "#include \"{}\"\n"
        "#include \"passes/study/method_values.glsl\"\n"
        "{}struct GatherKernel {{\n"
        "    float radius;\n    float bias;\n    float angle;\n    uint first;\n    uint count;\n"
        "}};\n"
        "vec2 method_gather(vec3 position, vec3 normal, GloamCamera camera, GatherKernel given, MethodValues "
        "values) {{\n"
        "    GloamKernel kernel = GloamKernel(given.radius, given.bias, given.angle, given.first, "
        "given.count,\n"
        "                                     uintBitsToFloat({}u));\n"
        "    values.layers = {};\n"
        "    GloamEstimate estimate = {};\n"
        "    return estimate.samples * vec2(estimate.occlusion, 1.0);\n"
        "}}\n",
        file_of(method), no_layers, std::bit_cast<std::uint32_t>(farthest), layers, call_of(method));
}

}  // namespace

MethodFunctions::MethodFunctions(int layers, float farthest) {
    for (const MethodInfo& method : methods())
        base::write_file(folder_.path() / file(method.name), text_for(method, layers, farthest));
}

}  // namespace gloam::effect
