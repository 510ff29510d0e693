// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "check/shader_test.hpp"
#include "shader/pack.hpp"
#include "support/method_functions.hpp"

// The methods as functions of one signature, and images for them.
namespace gloam::test {

using Camera = effect::GatherCamera;
using Samples = effect::GatherKernel;

// effect::MethodValues with the values that the views of the tests are made for.
struct Method {
    float range = 2.0F;
    float epsilon = 0.05F;
    float intensity = 0.2F;
    float thickness = 1e3F;
    float angle_bias = 0.0F;
    float mip_distance = 0.0F;
    unsigned steps = 16;
    float disagreement = 0.05F;
    float feature_thickness = 1e18F;
};

using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Samples, Method);

using Depths = std::function<float(glm::ivec2)>;
using Normals = std::function<glm::vec3(glm::ivec2)>;

// What the eye sees; normals that are not given face it.
inline check::ImageSet view_of(
    glm::ivec2 size, const Depths& depth,
    const Normals& normal = [](glm::ivec2) { return glm::vec3(0, 0, 1); }) {
    return {{"gloam_fetch_depth", check::make_image<float>(size, depth)},
            {"gloam_fetch_normal", check::make_image<glm::vec3>(size, normal)}};
}

// A method's function as one text.
inline std::string packed_method(const MethodFunctions& functions, const std::string& file) {
    return shader::pack(std::vector{functions.folder() / file}, {.functions = {effect::method_function}},
                        {functions.folder(), GLOAM_GLSL_DIR});
}

// The images that a packed text declares.
inline check::ImageSet declared_in(const std::string& text, check::ImageSet images) {
    std::erase_if(images,
                  [&text](const auto& image) { return text.find(image.first + "(") == std::string::npos; });
    return images;
}

}  // namespace gloam::test
