// SPDX-License-Identifier: MIT
#pragma once

#include "support/method_names.hpp"

// The methods as functions of one signature, and images for them.
namespace gloam::test {

using Camera = effect::GatherCamera;
using Samples = effect::GatherKernel;
using Method = effect::MethodValues;
using Gather = effect::MethodGather;
using GatherInputs = check::Function<Gather>::Inputs;

// The methods as kernels of one lab. layers, farthest: as effect::MethodFunctions has them.
class Gathers {
  public:
    explicit Gathers(int layers = 1, float farthest = infinity) : functions_(layers, farthest) {}

    [[nodiscard]] check::Function<Gather> operator[](const std::string& method) const {
        return {lab_, functions_.file(method), effect::method_function};
    }
    // Of a file of that folder.
    [[nodiscard]] check::Function<Gather> in_file(const std::string& file) const {
        return {lab_, file, effect::method_function};
    }
    [[nodiscard]] const check::Lab& lab() const { return lab_; }
    [[nodiscard]] const MethodFunctions& functions() const { return functions_; }

  private:
    MethodFunctions functions_;
    check::Lab lab_ = functions_.lab();
};

using Depths = std::function<float(glm::ivec2)>;
using Normals = std::function<glm::vec3(glm::ivec2)>;

// What the eye sees; normals that are not given face it.
inline check::ImageSet view_of(
    glm::ivec2 size, const Depths& depth,
    const Normals& normal = [](glm::ivec2) { return glm::vec3(0, 0, 1); }) {
    return {{"gloam_fetch_depth", check::make_image<float>(size, depth)},
            {"gloam_fetch_normal", check::make_image<glm::vec3>(size, normal)}};
}

// The point under a pixel, in view space, of the plane through (0, 0, -5).
inline glm::dvec3 plane_point(const Camera& camera, glm::dvec3 normal, glm::ivec2 pixel) {
    const glm::dvec2 size(camera.size);
    const glm::dvec2 side = (2.0 * glm::dvec2(pixel) + 1.0 - size) / size / glm::dvec2(camera.p00_p11);
    const double at_five = -5.0 * normal.z;
    if (camera.orthographic) return {side, (at_five - normal.x * side.x - normal.y * side.y) / normal.z};
    const glm::dvec3 ray(side, -1.0);
    return ray * (at_five / glm::dot(ray, normal));
}

// A method's function as one text.
inline std::string packed_method(const MethodFunctions& functions, const std::string& file) {
    return shader::pack(std::vector{functions.folder() / file}, {.functions = {effect::method_function}},
                        {functions.folder(), GLOAM_GLSL_DIR});
}

}  // namespace gloam::test
