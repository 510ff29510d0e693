// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "check/kernel.hpp"
#include "effect/methods.hpp"

namespace gloam::stress {

// GloamCamera and GloamKernel of the shader library, member by member.
struct Camera {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    bool orthographic;
};
struct GatherKernel {
    float radius;
    float bias;
    float angle;
    unsigned first;
    unsigned count;
};

struct GatherMethod {
    float range;
    float epsilon;
    float intensity = 1.0F;
    float thickness = 1.0F;
    float angle_bias = 0.0F;
    float mip_distance = 0.0F;
    unsigned steps = 1;
};

// (position, normal, camera, kernel, method) to (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Kernel<glm::vec2(glm::vec3, glm::vec3, Camera, GatherKernel, GatherMethod)>;

[[nodiscard]] constexpr GatherMethod method_of_length(float length) {
    return {.range = length, .epsilon = length};
}

constexpr const char* gather_function = "gloam_method_gather";

[[nodiscard]] inline std::string gather_file(const effect::MethodInfo& method) {
    return "passes/methods/" + method.name + ".glsl";
}

}  // namespace gloam::stress
