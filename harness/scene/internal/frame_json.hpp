// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "gpu/image.hpp"
#include "scene/camera.hpp"

namespace gloam::scene {

// The content of fNNNN.json.
struct FrameDescription {
    gpu::Extent extent;
    CameraFrame camera;
    std::optional<double> ao_radius;
    gpu::Extent border;
};

// Reads it. Throws std::runtime_error with the file's name, the key and what was expected.
[[nodiscard]] FrameDescription read_frame_json(const std::filesystem::path& file);

}  // namespace gloam::scene
