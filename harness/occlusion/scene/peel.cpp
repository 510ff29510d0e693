// SPDX-License-Identifier: MIT
#include "scene/internal/peel.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "backend/vulkan/commands.hpp"

namespace gloam::scene {
namespace {

gpu::Buffer index_buffer(const gpu::Device& device, const Mesh& mesh) {
    gpu::Buffer buffer(device, mesh.indices.size() * sizeof(std::uint32_t));
    std::ranges::copy(mesh.indices, buffer.as<std::uint32_t>().begin());
    return buffer;
}

gpu::RasterPipeline make_pipeline(const gpu::Device& device, const PassLibrary& passes, bool reversed_z) {
    const shader::Spirv vertex = passes.compile("gbuffer.vert");
    const shader::Spirv fragment = passes.compile("peel.frag");
    return {device,
            {.vertex_spirv = vertex,
             .fragment_spirv = fragment,
             .attribute_sizes = {3, 3},
             .color_formats = {gpu::Format::rgba32f},
             .push_constant_bytes = sizeof(PeelConstants),
             .reversed_z = reversed_z,
             .bindings = {gpu::BindingKind::storage_image}}};
}

// A layer in front of every surface.
std::vector<float> before_all(gpu::Extent extent, bool reversed_z) {
    std::vector<float> texels;
    for (std::size_t i = 0; i < std::size_t{extent.width} * extent.height; ++i)
        texels.insert(texels.end(), {0.0F, reversed_z ? 2.0F : -1.0F, 0.0F, 1.0F});
    return texels;
}

std::vector<float> depths_of(const std::vector<float>& texels) {
    std::vector<float> depths(texels.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const float depth = texels[4 * i];
        depths[i] = depth != 0.0F ? depth : std::numeric_limits<float>::infinity();
    }
    return depths;
}

}  // namespace

std::vector<std::vector<float>> peel(const gpu::Device& device, const PassLibrary& passes, const Mesh& mesh,
                                     const PeelView& view, int count) {
    const gpu::RasterPipeline pipeline = make_pipeline(device, passes, view.reversed_z);
    const gpu::Buffer vertices = vertex_buffer(device, mesh);
    const gpu::Buffer indices = index_buffer(device, mesh);
    const PeelConstants push{view.projection, view.reversed_z ? 1U : 0U};
    const gpu::Image depth(device, view.extent, gpu::Format::depth32f);
    std::array layers{gpu::Image(device, view.extent, gpu::Format::rgba32f),
                      gpu::Image(device, view.extent, gpu::Format::rgba32f)};
    layers[0].upload(before_all(view.extent, view.reversed_z));
    std::vector<std::vector<float>> found;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const gpu::Image& now = layers[(i + 1) % 2];
        const gpu::Draw all{.vertices = vertices,
                            .indices = indices,
                            .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                            .push_constants = std::as_bytes(std::span(&push, 1)),
                            .resources = {layers[i % 2]}};
        const std::array colors{std::cref(now)};
        gpu::Commands commands(device);
        gpu::render(commands, pipeline, colors, depth, 0.0F, std::span(&all, 1));
        commands.submit();
        found.push_back(depths_of(now.download()));
    }
    return found;
}

}  // namespace gloam::scene
