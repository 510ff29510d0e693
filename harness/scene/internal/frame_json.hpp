// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "gpu/image.hpp"
#include "scene/camera.hpp"

namespace gloam::scene {

// What fNNNN.json says.
struct FrameDescription {
    gpu::Extent extent;
    CameraFrame camera;
    std::optional<double> ao_radius;
    gpu::Extent border;
};

// Throws std::runtime_error that names the file, the key and what was expected.
[[nodiscard]] FrameDescription read_frame_json(const std::filesystem::path& file);

}  // namespace gloam::scene
