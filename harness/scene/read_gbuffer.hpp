// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// The name that the files of a frame begin with: "f0007". Throws std::invalid_argument outside 0 to 9999.
[[nodiscard]] std::string frame_prefix(int frame);

// The frames of a directory (those with an fNNNN.json), ascending. Throws std::runtime_error that names the
// directory when it is missing or holds none.
[[nodiscard]] std::vector<int> frames_of(const std::filesystem::path& directory);

// Reads one frame: PREFIX.json, PREFIX_depth, and, when they are there, PREFIX_normal, PREFIX_motion,
// PREFIX_previous_depth, PREFIX_layer1 to 3 and PREFIX_color, each image as .pfm or .exr. A depth that is not
// positive and finite becomes +infinity; normals are normalised, and 0 where they have no direction and at
// the background; layers that are 0 or not finite become +infinity; motion that is not finite becomes 0, not
// valid. Throws std::runtime_error with one line that names the file and what was expected: missing,
// malformed or cut short, a size that disagrees, an image offered in both kinds, a matrix that cannot be
// inverted, a projection that is not symmetric (beyond a pixel of jitter).
[[nodiscard]] GBuffer read_gbuffer(const std::filesystem::path& directory, int frame);

// The text of PREFIX.json for a frame; read_gbuffer reads the same camera back, exactly.
[[nodiscard]] std::string frame_json(const GBuffer& gbuffer, int frame);

}  // namespace gloam::scene
