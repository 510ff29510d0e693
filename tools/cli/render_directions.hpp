// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "effect/directional.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// The environment that --light names: white, sky, or a file. Throws std::runtime_error that names the file.
[[nodiscard]] scene::Environment environment_named(const std::string& name);

// STEM_bent.pfm (x, y, z in view space) and .png (0.5 + 0.5 of it), STEM_cone.pfm (half angle, radians).
void write_bent_normals(report::OutputFolder& folder, const std::string& stem,
                        const effect::BentNormals& bent);

// STEM_light.pfm (linear radiance, direct and bounced) and .png (sRGB, white from 1 on), STEM_bounce.pfm
// (what of it has bounced).
void write_light(report::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light);

}  // namespace gloam::cli
