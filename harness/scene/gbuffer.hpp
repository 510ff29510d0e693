// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "scene/scene.hpp"
#include "shader/cache.hpp"

namespace gloam::scene {

// What an engine hands to an ambient-occlusion effect: one frame, rows from the top.
struct GBuffer {
    gpu::Extent extent;
    std::vector<float> depth;       // eye-linear, world units; background +infinity
    std::vector<glm::vec3> normal;  // view space, unit length, facing the viewer; background 0. Empty: to be reconstructed
    std::vector<glm::vec3> motion;  // dx, dy in pixels (y down), valid; empty: from the cameras alone
    CameraFrame camera;
    std::optional<double> ao_radius;  // world units
};

// Reads and writes one frame as docs/gbuffer-format.md says: DIR/fNNNN.json, _depth, _normal, _motion as .pfm or .exr.
// read: depth that is 0, negative or not finite becomes +infinity. Throws std::runtime_error with one line that names the
// file and what was expected: missing, cut short, sizes that disagree, both kinds offered, a singular matrix, bad JSON.
[[nodiscard]] GBuffer read_gbuffer(const std::filesystem::path& directory, int frame);
void write_gbuffer(const std::filesystem::path& directory, int frame, const GBuffer& gbuffer);

// The frames that a directory holds (fNNNN.json), ascending. Throws std::runtime_error when there is no directory or no frame.
[[nodiscard]] std::vector<int> frames_of(const std::filesystem::path& directory);

// Rasterises a scene on the device into depth and normals, as an engine would: the hardware's depth buffer, linearised by
// the library's own function. `glsl` is the folder that holds gloam/ and passes/. Throws std::runtime_error for a size of
// 0 or beyond the device's limit.
[[nodiscard]] GBuffer rasterize(const gpu::Device& device, const std::filesystem::path& glsl, const shader::SpirvCache& cache,
                                const Scene& scene, gpu::Extent extent);

}  // namespace gloam::scene
