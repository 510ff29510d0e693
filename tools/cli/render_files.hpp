// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "report/output_folder.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::cli {

// x, y, z of each.
[[nodiscard]] std::vector<float> components_of(const std::vector<glm::vec3>& vectors);

// A frame of docs/gbuffer-format.md. What read_gbuffer() and link() make of it is the view again, within the
// rounding of the files.
void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view);

// fNNNN_ao.pfm and .png, of the filtered image.
void write_images(report::OutputFolder& folder, int number, const effect::Frame& frame);

// fNNNN_error.png: the magnitude of the error; an error of 0.25 is as bright as the scale goes.
void write_error(report::OutputFolder& folder, int number, const effect::Frame& frame,
                 const effect::Truth& truth);

}  // namespace gloam::cli
