// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {

// Tests of frames at half the resolution.
class HalfSize : public OnDevice<testing::Test> {
  public:
    static constexpr gpu::Extent extent{83, 46};

  protected:
    [[nodiscard]] static Settings half(Settings settings, float radius = 0.5F) {
        settings.resolution = Resolution::half;
        return with_radius(settings, radius);
    }

    [[nodiscard]] scene::GBuffer view(const std::string& scene, int frame = 0,
                                      const scene::RasterizeOptions& options = {.motion = true},
                                      gpu::Extent size = extent) const {
        scene::RasterizeOptions of_frame = options;
        of_frame.frame = frame;
        return rasterized(scene, size, of_frame);
    }

    [[nodiscard]] std::vector<scene::GBuffer> views(const std::string& scene, int count,
                                                    int first = 0) const {
        std::vector<scene::GBuffer> all;
        for (int i = 0; i < count; ++i) all.push_back(view(scene, first + i));
        return all;
    }
};

}  // namespace gloam::effect
