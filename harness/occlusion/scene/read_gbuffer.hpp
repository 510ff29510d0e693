// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "base/image_files.hpp"
#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::scene {

// The first part of a frame's file names: "f0007". Throws std::invalid_argument for a frame outside 0 to
// 9999.
[[nodiscard]] std::string frame_prefix(int frame);

// The frames of a directory (those with an fNNNN.json), ascending. Throws std::runtime_error with the
// directory's name if it is missing or has no frame.
[[nodiscard]] std::vector<int> frames_of(const std::filesystem::path& directory);

// Reads one frame: PREFIX.json, PREFIX_depth, and, when they are there, PREFIX_normal, PREFIX_motion,
// PREFIX_previous_depth, PREFIX_layer1 to 3 and PREFIX_color, each image as .pfm or .exr. A depth that is not
// positive and finite becomes +infinity; normals are normalised, and 0 where they have no direction and at
// the background; layers that are 0 or not finite become +infinity; motion that is not finite becomes 0, not
// valid. Throws std::runtime_error with one line that names the file and what was expected: missing,
// malformed or cut short, a size that disagrees, an image offered in both kinds, a matrix that cannot be
// inverted or is written row by row, a skewed projection. A left-handed view becomes right-handed.
// encoding: of PREFIX_depth and PREFIX_normal. With another than the default, the GBuffer also has them as
// they are stored. off_centre: of the frame before; a jitter of the projection does not change it. For the
// effect the result has to be centred().
[[nodiscard]] GBuffer read_gbuffer(const std::filesystem::path& directory, int frame,
                                   const Encoding& encoding = {}, const glm::ivec2& off_centre = {0, 0});

// One sentence on how the buffers of a frame contradict each other, or what was said of them; empty where
// they do not. Each kind is a habit of engines that gives a wrong picture, often one without occlusion:
// values outside [0, 1] in a depth buffer; surfaces on the near plane (Z is reversed in one of projection and
// buffer); depths outside of the projection's planes, or those of a depth buffer read as eye-linear; normals
// that are 0, have another length than 1, face away from the eye, or disagree with the depth (another space
// or encoding; depth that is the distance to the eye). A kind is reported where most of the surface shows it,
// so single pixels may be wrong; a frame of fewer than 64 pixels shows too little. view: as read_gbuffer()
// returns it. as_stored: the same depth and normals before they were converted.
[[nodiscard]] std::string contradiction_of(const GBuffer& view, const StoredInputs& as_stored);

// One sentence on why a radius (world units, > 0) gives no occlusion in a view: it is below a pixel at the
// nearest surface, or more than a thousand times the distance of the farthest one. Empty: it fits, or there
// is no surface.
[[nodiscard]] std::string radius_out_of_proportion(const GBuffer& view, double radius);

// One sentence on a view whose stored depth has steps, at most of the surface, of more than a tenth of a
// radius (world units); it names near and far. Empty: they are smaller.
[[nodiscard]] std::string too_coarse_steps(const GBuffer& view, double radius);

// Reads the first part of an OpenEXR file: float, half or integer channels, the whole data window. For one
// channel it takes Y, Z, R, depth, or the only one; for three R G B, or X Y Z. Throws std::runtime_error with
// the file's name and what was expected.
[[nodiscard]] base::FloatImage read_exr(const std::filesystem::path& file, int channels);

// The text of a frame's PREFIX.json; read_gbuffer reads exactly the same camera from it.
[[nodiscard]] std::string frame_json(const GBuffer& gbuffer, int frame);

// The content of fNNNN.json.
struct FrameDescription {
    GBuffer view;              // the viewport, without images
    Border around;             // the viewport in the images
    glm::dvec2 off_centre{0};  // as that of GBuffer, not rounded
    bool left_handed = false;  // the engine's view space; that of `view` is right-handed
};

// Reads it. Throws std::runtime_error with the file's name, the key and what was expected.
[[nodiscard]] FrameDescription read_frame_json(const std::filesystem::path& file);

}  // namespace gloam::scene
