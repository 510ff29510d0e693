// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The lit image, computed on the device by composite.comp: ambient * (1 - occlusion) + direct.
class Composite {
  public:
    // The device must outlive this object. Throws std::runtime_error when the shader does not compile.
    Composite(const backend::vulkan::Device& device, const scene::PassLibrary& passes);

    // The lit image, linear, rows from the top. `ambient` and `direct`: light of each pixel, linear.
    // `occlusion`: in [0, 1], a value for each pixel; empty: no occlusion. `albedo`: linear, for each pixel,
    // with which light bounces among blockers (gloam_multi_bounce); empty: it does not. Each
    // has as many pixels as the extent.
    [[nodiscard]] std::vector<glm::vec3> lit(backend::Extent extent, std::span<const glm::vec3> ambient,
                                             std::span<const glm::vec3> direct,
                                             const std::vector<float>& occlusion,
                                             const std::vector<glm::vec3>& albedo = {}) const;

  private:
    const backend::vulkan::Device* device_;
    backend::vulkan::ComputePipeline pipeline_;
};

}  // namespace gloam::effect
