// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "check/question.hpp"

namespace gloam::catalogue {

// The image sizes that every image-reading function is checked on: 1 x 1, 3 x 3, odd, wide, tall; `make`
// fills them.
[[nodiscard]] std::vector<check::ImageScenario> image_scenarios(
    const std::function<check::ImageSet(glm::ivec2 size, numeric::Random& random)>& make);

// Eye-linear depth images (element float) of those sizes under the given prototype name: a slanted surface
// with steps and holes of background (+infinity), and one scenario that is all background.
[[nodiscard]] std::vector<check::ImageScenario> depth_scenarios(const std::string& prototype);

}  // namespace gloam::catalogue
