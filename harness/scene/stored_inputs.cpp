// SPDX-License-Identifier: MIT
#include "scene/stored_inputs.hpp"

namespace gloam::scene {

StoredInputs stored_inputs(const GBuffer& view, const Encoding& encoding) {
    StoredInputs stored{.encoding = encoding, .depth = {}, .normal = {}};
    for (const float depth : view.depth)
        stored.depth.push_back(static_cast<float>(stored_depth(double{depth}, encoding, view.camera)));
    for (const glm::vec3& normal : view.normal)
        stored.normal.emplace_back(stored_normal(glm::dvec3(normal), encoding, view.camera));
    return stored;
}

}  // namespace gloam::scene
