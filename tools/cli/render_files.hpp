// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "report/output_folder.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::cli {

// x, y, z of each vector.
[[nodiscard]] std::vector<float> components_of(const std::vector<glm::vec3>& vectors);

// Writes a frame of docs/gbuffer-format.md. read_gbuffer() and link() restore the view from it, within the
// rounding of the files.
void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view);

// STEM_ao.pfm and .png, of the filtered image.
void write_images(report::OutputFolder& folder, const std::string& stem, const effect::Frame& frame);

}  // namespace gloam::cli
