// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "check/question.hpp"

namespace gloam::catalogue {

// Images of the sizes on which every image-reading function is checked: 1 x 1, odd, wide, tall.
// `make`: fills them.
[[nodiscard]] std::vector<check::ImageScenario> image_scenarios(
    const std::function<check::ImageSet(glm::ivec2 size, numeric::Random& random)>& make);

// Eye-linear depth images (float) of those sizes for a prototype: a slanted surface with steps and holes of
// background (+infinity), and one scenario of background alone.
[[nodiscard]] std::vector<check::ImageScenario> depth_scenarios(const std::string& prototype);

}  // namespace gloam::catalogue
