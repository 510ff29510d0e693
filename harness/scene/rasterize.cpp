// SPDX-License-Identifier: MIT
#include "scene/rasterize.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "gpu/raster.hpp"

namespace gloam::scene {
namespace {

// As in gbuffer.vert and gbuffer.frag.
struct PushConstants {
    glm::mat4 view;
    glm::mat4 projection;
};

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
};

// The device reads wherever an index points.
void check_mesh(const Scene& scene) {
    const Mesh& mesh = scene.mesh;
    const auto fail = [&](const std::string& what) {
        throw std::invalid_argument("scene " + scene.name + ": " + what);
    };
    if (mesh.triangle_count() == 0) fail("no triangles in it");
    if (mesh.indices.size() % 3 != 0)
        fail(std::to_string(mesh.indices.size()) + " indices, expected three for each triangle");
    if (mesh.normals.size() != mesh.positions.size())
        fail(std::to_string(mesh.normals.size()) + " normals for " + std::to_string(mesh.positions.size()) +
             " positions");
    const std::uint32_t largest = *std::ranges::max_element(mesh.indices);
    if (largest >= mesh.positions.size())
        fail("index " + std::to_string(largest) + " is beyond its " + std::to_string(mesh.positions.size()) +
             " positions");
}

gpu::Buffer vertex_buffer(const gpu::Device& device, const Mesh& mesh) {
    gpu::Buffer buffer(device, mesh.positions.size() * sizeof(Vertex));
    const std::span<Vertex> vertices = buffer.as<Vertex>();
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = {mesh.positions[i], mesh.normals[i]};
    return buffer;
}

gpu::Buffer index_buffer(const gpu::Device& device, const Mesh& mesh) {
    gpu::Buffer buffer(device, mesh.indices.size() * sizeof(std::uint32_t));
    std::ranges::copy(mesh.indices, buffer.as<std::uint32_t>().begin());
    return buffer;
}

gpu::RasterPipeline make_pipeline(const gpu::Device& device, const PassLibrary& passes, bool reversed_z) {
    const shader::Spirv vertex = passes.compile("gbuffer.vert");
    const shader::Spirv fragment = passes.compile("gbuffer.frag");
    return {device,
            {.vertex_spirv = vertex,
             .fragment_spirv = fragment,
             .attribute_sizes = {3, 3},
             .color_formats = {gpu::Format::r32f, gpu::Format::rgba32f},
             .push_constant_bytes = sizeof(PushConstants),
             .reversed_z = reversed_z}};
}

std::vector<glm::vec3> to_vectors(const std::vector<float>& texels) {
    std::vector<glm::vec3> vectors(texels.size() / 4);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        vectors[i] = {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]};
    return vectors;
}

}  // namespace

GBuffer rasterize(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
                  gpu::Extent extent) {
    check_mesh(scene);
    const gpu::Image depth(device, extent, gpu::Format::depth32f);
    const gpu::Image linear(device, extent, gpu::Format::r32f);
    const gpu::Image normal(device, extent, gpu::Format::rgba32f);
    const double aspect = static_cast<double>(extent.width) / extent.height;
    GBuffer gbuffer{
        .extent = extent, .camera = make_frame(scene.camera, aspect), .ao_radius = scene.ao_radius};

    const gpu::RasterPipeline pipeline = make_pipeline(device, passes, scene.camera.reversed_z);
    const gpu::Buffer vertices = vertex_buffer(device, scene.mesh);
    const gpu::Buffer indices = index_buffer(device, scene.mesh);
    const PushConstants push{gbuffer.camera.view, gbuffer.camera.proj_vk};
    const gpu::Draw draw{.vertices = vertices,
                         .indices = indices,
                         .index_count = static_cast<std::uint32_t>(scene.mesh.indices.size()),
                         .push_constants = std::as_bytes(std::span(&push, 1))};
    const std::array<std::reference_wrapper<const gpu::Image>, 2> colors{linear, normal};
    gpu::Commands commands(device);
    gpu::render(commands, pipeline, colors, depth, 0.0F, std::span(&draw, 1));
    commands.submit();

    gbuffer.depth = linear.download();
    for (float& d : gbuffer.depth) {
        if (!(d > 0.0F)) d = std::numeric_limits<float>::infinity();  // cleared to 0: nothing drawn
    }
    gbuffer.normal = to_vectors(normal.download());
    return gbuffer;
}

}  // namespace gloam::scene
