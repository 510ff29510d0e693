// SPDX-License-Identifier: MIT
#include "cli/render_directions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/render_files.hpp"
#include "report/image.hpp"

namespace gloam::cli {
namespace {

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

}  // namespace

scene::Environment environment_named(const std::string& name) {
    if (name == "white") return scene::constant_environment(glm::vec3(1.0F));
    if (name == "sky") return scene::sky_environment();
    return scene::read_environment(name);
}

void write_bent_normals(report::OutputFolder& folder, const std::string& stem,
                        const effect::BentNormals& bent) {
    const auto [width, height] = bent.extent;
    const std::vector<float> texels = components_of(bent.direction);
    std::vector<std::uint8_t> picture;
    for (const float value : texels) picture.push_back(byte_of(0.5F + 0.5F * value));
    folder.write(stem + "_bent.pfm", report::to_pfm(texels, width, height, 3));
    folder.write(stem + "_bent.png", report::to_rgb_png(picture, width, height));
    folder.write(stem + "_cone.pfm", report::to_pfm(bent.half_angle, width, height, 1));
}

void write_light(report::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light) {
    const auto [width, height] = light.extent;
    std::vector<float> texels = components_of(light.direct);
    const std::vector<float> bounced = components_of(light.bounced);
    std::ranges::transform(texels, bounced, texels.begin(), std::plus{});
    folder.write(stem + "_light.pfm", report::to_pfm(texels, width, height, 3));
    folder.write(stem + "_light.png", report::to_rgb_png(report::srgb_of(texels), width, height));
    folder.write(stem + "_bounce.pfm", report::to_pfm(bounced, width, height, 3));
}

}  // namespace gloam::cli
