// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"

#include <cmath>

#include "catalogue/inputs.hpp"

namespace gloam::catalogue {

using namespace check;

Values cameras() {
    return vector({log_uniform(0.5, 3).and_special(), signed_log_uniform(0.5, 3).and_special(), image_size(),
                   booleans()});
}

std::function<void(std::span<Word>)> place_before_camera(std::size_t position, std::size_t camera) {
    return [position, camera](std::span<Word> words) {
        const auto number = [&](std::size_t i) { return from_word<double>(words[i]); };
        const glm::dvec2 ndc(number(position), number(position + 1));
        const glm::dvec2 scale(number(camera), number(camera + 1));
        const double depth = number(position + 2);
        const bool drawn = std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0 && depth >= 1.0 && depth <= 4.0;
        if (!drawn) return;
        const bool orthographic = words[camera + 4] != 0U;
        const glm::dvec2 side = ndc / scale * (orthographic ? 1.0 : depth);
        words[position] = to_word(side.x);
        words[position + 1] = to_word(side.y);
        words[position + 2] = to_word(-depth);
    };
}

}  // namespace gloam::catalogue
