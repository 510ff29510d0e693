// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "check/kernel.hpp"

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

// (position, normal, camera, kernel, range or epsilon) to (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Kernel<glm::vec2(glm::vec3, glm::vec3, Camera, GatherKernel, float)>;

struct GatherFunction {
    const char* file;
    const char* name;
};

[[nodiscard]] constexpr std::array<GatherFunction, 2> gather_functions() {
    return {{{"gloam/occlusion/hemisphere_gather.glsl", "gloam_hemisphere_gather"},
             {"gloam/occlusion/disc_gather.glsl", "gloam_disc_gather"}}};
}

}  // namespace gloam::stress
