// SPDX-License-Identifier: MIT
#include "effect/method_functions.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace gloam::effect {
namespace {

std::string text_for(const MethodInfo& method, int layers, float farthest) {
    const char* no_layers =
        layers > 1 ? "" : "vec3 gloam_fetch_layers(ivec2 pixel) {\n    return vec3(0.0);\n}\n";
    return fmt::format(
        "#include \"{}\"\n"
        "#include \"passes/method_values.glsl\"\n"
        "{}"
        "struct GatherKernel {{\n    float radius;\n    float bias;\n    float angle;\n    uint first;\n    "
        "uint count;\n}};\n"
        "vec2 method_gather(vec3 position, vec3 normal, GloamCamera camera, GatherKernel given, MethodValues "
        "values) {{\n"
        "    GloamKernel kernel = GloamKernel(given.radius, given.bias, given.angle, given.first, "
        "given.count,\n"
        "                                     uintBitsToFloat({}u), {}, false);\n"
        "    GloamEstimate estimate = {};\n"
        "    return estimate.samples * vec2(estimate.occlusion, 1.0);\n"
        "}}\n",
        file_of(method), no_layers, std::bit_cast<std::uint32_t>(farthest), layers, call_of(method));
}

}  // namespace

MethodFunctions::MethodFunctions(int layers, float farthest) {
    std::string name = (std::filesystem::temp_directory_path() / "gloam-methods-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make the folder " + name);
    folder_ = name;
    for (const MethodInfo& method : methods()) {
        const std::filesystem::path path = folder_ / file(method.name);
        std::ofstream out(path);
        out << text_for(method, layers, farthest);
        out.close();
        if (!out) throw std::runtime_error("cannot write " + path.string());
    }
}

MethodFunctions::~MethodFunctions() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace gloam::effect
