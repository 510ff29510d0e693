// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "scene/mesh.hpp"
#include "scene/pass_library.hpp"

namespace gloam::scene {

// Push constants, with the layout of gbuffer.vert and gbuffer.frag.
struct RasterConstants {
    glm::mat4 projection;
};

// Push constants, with the layout of peel.frag; gbuffer.vert reads the first member.
struct PeelConstants {
    glm::mat4 projection;
    std::uint32_t reversed_z;
};

// The vertex that gbuffer.vert reads without GLOAM_MOTION.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
};

// All vertices of a mesh.
[[nodiscard]] inline gpu::Buffer vertex_buffer(const gpu::Device& device, const Mesh& mesh) {
    gpu::Buffer buffer(device, mesh.positions.size() * sizeof(Vertex));
    const std::span<Vertex> vertices = buffer.as<Vertex>();
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = {mesh.positions[i], mesh.normals[i]};
    return buffer;
}

// The view of a mesh.
struct PeelView {
    gpu::Extent extent;
    glm::mat4 projection;  // view to clip
    bool reversed_z = false;
};

// The depth layers of a mesh in view space, nearest first, with the values of GBuffer::layers: `count`
// images. Surfaces of exactly equal depth form one layer. Throws like gpu::Commands::submit().
[[nodiscard]] std::vector<std::vector<float>> peel(const gpu::Device& device, const PassLibrary& passes,
                                                   const Mesh& mesh, const PeelView& view, int count);

}  // namespace gloam::scene
