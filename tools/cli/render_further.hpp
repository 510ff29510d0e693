// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "report/output_folder.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {

constexpr int most_further_views = 6;

// The views of `count` further cameras in a frame of a scene. They look at the same target as the scene's
// camera from the same distance, rotated about the vertical by 40 degrees to both sides, then by 80 and 120.
[[nodiscard]] std::vector<scene::GBuffer> further_views_of(const gpu::Device& device,
                                                           const scene::PassLibrary& passes,
                                                           const scene::Scene& scene, int frame,
                                                           gpu::Extent extent, int count);

// STEM_views.pfm and .png: occlusion, as of the frame itself.
void write_further(report::OutputFolder& folder, const std::string& stem, gpu::Extent extent,
                   const std::vector<float>& occlusion);

}  // namespace gloam::cli
