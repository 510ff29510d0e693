// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "gpu/buffer.hpp"
#include "scene/mesh.hpp"

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

}  // namespace gloam::scene
