// SPDX-License-Identifier: MIT
#include "effect/composite.hpp"

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"

namespace gloam::effect {
namespace {

using enum backend::vulkan::Format;

// Push constants of composite.comp.
struct Parameters {
    glm::ivec2 size;
    std::uint32_t multi_bounce;
};

}  // namespace

Composite::Composite(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
    : device_(&device), pipeline_(pipeline_of(device, passes, {.file = "study/composite.comp"})) {}

std::vector<glm::vec3> Composite::lit(backend::Extent extent, std::span<const glm::vec3> ambient,
                                      std::span<const glm::vec3> direct, const std::vector<float>& occlusion,
                                      const std::vector<glm::vec3>& albedo) const {
    backend::vulkan::Image around(*device_, extent, rgba32f);
    backend::vulkan::Image lamp(*device_, extent, rgba32f);
    backend::vulkan::Image shown(*device_, extent, r32f);
    const backend::vulkan::Image image(*device_, extent, rgba32f);
    around.upload(texels_of(ambient));
    lamp.upload(texels_of(direct));
    shown.upload(occlusion.empty() ? std::vector(ambient.size(), 0.0F) : occlusion);
    backend::vulkan::Image color(*device_, albedo.empty() ? backend::Extent{1, 1} : extent, rgba32f);
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
