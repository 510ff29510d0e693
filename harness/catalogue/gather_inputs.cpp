// SPDX-License-Identifier: MIT
#include "catalogue/gather_inputs.hpp"

#include "catalogue/inputs.hpp"
#include "catalogue/scenarios.hpp"

namespace gloam::catalogue {

using namespace check;

Values gather_positions() {
    return vector({uniform(-1, 1), uniform(-1, 1), uniform(1, 4)}).and_special();
}

Values gather_kernels() {
    return vector({log_uniform(0.05, 2).and_special(), log_uniform(1e-3, 0.1).and_special(),
                   uniform(0, 6.2831853).and_special(),
                   log_integers(16777216).and_near_integers({16777216, 4294967295}), integers(0, 8),
                   either(constant(1e18F), uniform(-0.5, 2)).and_special(), integers(1, 4), constant(false)});
}

Values gather_length() {
    return log_uniform(0.01, 4).and_special();
}

bool usual_gather(const glm::vec3& position, const glm::vec3& normal, const reference::GloamCamera& camera,
                  const reference::GloamKernel& kernel) {
    return moderate(1e-9, 1e9, position, normal, camera.p00_p11, kernel.radius, kernel.bias);
}

std::vector<check::ImageScenario> gather_scenarios() {
    std::vector<check::ImageScenario> scenarios = depth_scenarios(depth_prototype);
    for (check::ImageScenario& scenario : scenarios) {
        scenario.make = [make = scenario.make](glm::ivec2 size, numeric::Random& random) {
            check::ImageSet images = make(size, random);
            const auto layer = [&random] {
                const auto depth = static_cast<float>(random.uniform(1.0, 4.0));
                const auto kind = random.below(4);
                return kind == 0 ? 0.0F : (kind == 1 ? -depth : depth);
            };
            images.emplace("gloam_fetch_layers", check::make_image<glm::vec3>(size, [&](glm::ivec2) {
                               return glm::vec3(layer(), layer(), layer());
                           }));
            return images;
        };
    }
    return scenarios;
}

}  // namespace gloam::catalogue
