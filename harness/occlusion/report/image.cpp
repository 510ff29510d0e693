// SPDX-License-Identifier: MIT
#include "report/image.hpp"

#include <cmath>
#include <vector>

namespace gloam::report {
namespace {

std::uint8_t visibility_byte(float occlusion) {
    if (!(occlusion > 0.0F)) return 255;
    return static_cast<std::uint8_t>(std::lround(255.0F * (1.0F - std::fmin(occlusion, 1.0F))));
}

}  // namespace

base::RgbBytes visibility_rgb(std::span<const float> occlusion) {
    base::RgbBytes rgb;
    rgb.reserve(3 * occlusion.size());
    for (const float value : occlusion) rgb.insert(rgb.end(), 3, visibility_byte(value));
    return rgb;
}

std::string to_visibility_png(std::span<const float> occlusion, std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint8_t> grey;
    grey.reserve(occlusion.size());
    for (const float value : occlusion) grey.push_back(visibility_byte(value));
    return base::to_png(grey, width, height);
}

}  // namespace gloam::report
