// SPDX-License-Identifier: MIT
#include "effect/composite.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

// Push constants of composite.comp.
struct Parameters {
    glm::ivec2 size;
    std::uint32_t multi_bounce;
};

void require(std::size_t found, std::size_t expected, const char* what) {
    if (found == expected) return;
    throw std::invalid_argument(fmt::format("composite: {} {}, expected {}", found, what, expected));
}

}  // namespace

Composite::Composite(const gpu::Device& device, const scene::PassLibrary& passes)
    : device_(&device), pipeline_(pipeline_of(device, passes, {.file = "study/composite.comp"})) {}

std::vector<glm::vec3> Composite::lit(gpu::Extent extent, std::span<const glm::vec3> ambient,
                                      std::span<const glm::vec3> direct, std::span<const float> occlusion,
                                      const std::vector<glm::vec3>& albedo) const {
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    require(ambient.size(), pixels, "pixels with ambient light");
    require(direct.size(), pixels, "pixels with direct light");
    if (!occlusion.empty()) require(occlusion.size(), pixels, "occlusions");
    if (!albedo.empty()) require(albedo.size(), pixels, "albedos");
    gpu::Image around(*device_, extent, rgba32f);
    gpu::Image lamp(*device_, extent, rgba32f);
    gpu::Image shown(*device_, extent, r32f);
    const gpu::Image image(*device_, extent, rgba32f);
    around.upload(texels_of(ambient));
    lamp.upload(texels_of(direct));
    std::vector<float> values(occlusion.begin(), occlusion.end());
    values.resize(pixels, 0.0F);
    shown.upload(values);
    gpu::Image color(*device_, albedo.empty() ? gpu::Extent{1, 1} : extent, rgba32f);
    if (!albedo.empty()) color.upload(texels_of(albedo));
    const Parameters parameters{vector_of_size(extent), flag(!albedo.empty())};
    const Step step{"composite",
                    &pipeline_,
                    {around, lamp, shown, image, color},
                    bytes_of(parameters),
                    groups_for(extent)};
    (void)run(*device_, std::span(&step, 1), 1);
    return vectors_of(image.download());
}

}  // namespace gloam::effect
