// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "base/files.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {

// The methods as functions with one signature, for tests. They are files NAME.glsl in a temporary folder,
// with
//   vec2 method_gather(vec3 position, vec3 normal, GloamCamera camera, GatherKernel kernel, MethodValues
//   values)
// GatherKernel has the first five members of GloamKernel; MethodValues is that of
// passes/study/method_values.glsl. The function returns (samples times occlusion, samples). If `layers` is
// more than 1, it reads the layers behind the first by vec3 gloam_fetch_layers(ivec2). farthest: that member
// of GloamKernel, world units. Throws std::runtime_error for a file that cannot be written.
class MethodFunctions {
  public:
    explicit MethodFunctions(int layers = 1, float farthest = std::numeric_limits<float>::infinity());

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

    // The file of a method, for an #include from the folder.
    [[nodiscard]] static std::string file(const std::string& method) { return method + ".glsl"; }

  private:
    base::TemporaryFolder folder_{"methods"};
};

// The function's name.
inline constexpr const char* method_function = "method_gather";

// Its parameters, as gloam/geometry/camera.glsl and the files have them, and its signature for
// judge::Function.
struct GatherCamera {
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
using MethodGather = glm::vec2(glm::vec3, glm::vec3, GatherCamera, GatherKernel, MethodValues);

}  // namespace gloam::effect
