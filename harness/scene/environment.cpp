// SPDX-License-Identifier: MIT
#include "scene/environment.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scene/internal/exr.hpp"
#include "scene/pfm.hpp"

namespace gloam::scene {
namespace {

float sane(float value) {
    return value > 0.0F && std::isfinite(value) ? value : 0.0F;
}

FloatImage read(const std::filesystem::path& file) {
    if (file.extension() == ".pfm") return read_pfm(file);
    if (file.extension() == ".exr") return read_exr(file, 3);
    throw std::runtime_error(file.string() + ": expected an environment as .exr or .pfm");
}

}  // namespace

Environment constant_environment(const glm::vec3& radiance) {
    return {.extent = {1, 1}, .radiance = {radiance}};
}

Environment sky_environment() {
    constexpr std::uint32_t rows = 128;
    const glm::vec3 zenith(0.35F, 0.6F, 1.0F);
    const glm::vec3 horizon(1.0F, 1.0F, 1.0F);
    const glm::vec3 ground(0.25F, 0.22F, 0.18F);
    Environment sky{.extent = {1, rows}, .radiance = {}};
    for (std::uint32_t row = 0; row < rows; ++row) {
        const float height = static_cast<float>(std::cos((row + 0.5) * std::numbers::pi / rows));
        sky.radiance.push_back(height > 0.0F ? glm::mix(horizon, zenith, height) : ground);
    }
    return sky;
}

Environment read_environment(const std::filesystem::path& file) {
    const FloatImage image = read(file);
    if (image.channels != 3) throw std::runtime_error(file.string() + ": has 1 channel, expected 3");
    Environment environment{.extent = image.extent, .radiance = {}};
    for (std::size_t i = 0; i + 2 < image.texels.size(); i += 3) {
        environment.radiance.emplace_back(sane(image.texels[i]), sane(image.texels[i + 1]),
                                          sane(image.texels[i + 2]));
    }
    return environment;
}

}  // namespace gloam::scene
