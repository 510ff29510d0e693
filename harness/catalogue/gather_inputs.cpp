// SPDX-License-Identifier: MIT
#include "catalogue/gather_inputs.hpp"

#include "catalogue/inputs.hpp"

namespace gloam::catalogue {

using namespace check;

Values gather_positions() {
    return vector({uniform(-1, 1), uniform(-1, 1), uniform(1, 4)}).and_special();
}

Values gather_kernels() {
    return vector({log_uniform(0.05, 2).and_special(), log_uniform(1e-3, 0.1).and_special(),
                   uniform(0, 6.2831853).and_special(),
                   log_integers(16777216).and_near_integers({16777216, 4294967295}), integers(0, 8)});
}

Values gather_length() {
    return log_uniform(0.01, 4).and_special();
}

Values gather_methods() {
    const Values factor = uniform(0, 2).and_special();
    const Values angle = uniform(0, 1).and_special();
    const Values mip_distance = either(constant(0.0F), log_uniform(1, 64)).and_special();
    return vector({gather_length(), gather_length(), factor, gather_length(), angle, mip_distance,
                   integers(0, 4), uniform(0, 1).and_special()});
}

bool usual_gather(const glm::vec3& position, const glm::vec3& normal,
                  const reference::GloamCamera<float>& camera, const reference::GloamKernel<float>& kernel,
                  const reference::GloamMethod<float>& method) {
    return moderate(1e-9, 1e9, position, normal, camera.p00_p11, kernel.radius, kernel.bias, method.range,
                    method.epsilon, method.intensity, method.thickness);
}

}  // namespace gloam::catalogue
