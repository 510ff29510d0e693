// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "effect/directional.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// The environment of --light: white, sky, or a file. Throws std::runtime_error with the file's name.
[[nodiscard]] scene::Environment environment_named(const std::string& name);

// STEM_bent.pfm (x, y, z in view space) and .png (0.5 + 0.5 of it), STEM_cone.pfm (half angle, radians).
void write_bent_normals(report::OutputFolder& folder, const std::string& stem,
                        const effect::BentNormals& bent);

// Writes STEM_light.pfm (linear radiance, direct and bounced) and .png (sRGB, white from 1 on), and
// STEM_bounce.pfm (the bounced part).
void write_light(report::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light);

}  // namespace gloam::cli
