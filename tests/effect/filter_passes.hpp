// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "gpu/commands.hpp"
#include "numeric/random.hpp"

namespace gloam::effect {

// Push constants of spatial_filter.comp.
struct FilterConstants {
    glm::vec2 p00_p11{1.0F, -1.0F};
    glm::ivec2 size{0};
    float sigma_pixels = 1.5F;
    float depth_scale = 0.1F;
    float c_adaptive = 1.0F;
    float weight_max = 100.0F;
    float cap = 1e18F;
};

struct Field {
    glm::ivec2 size;
    std::vector<float> occlusion;
    std::vector<float> depth;
    std::vector<glm::vec3> normal;
    std::vector<float> samples;  // accumulated; empty: 50 everywhere

    [[nodiscard]] std::size_t at(glm::ivec2 p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(p.x);
    }
};

inline Field random_field(glm::ivec2 size, float depth_range) {
    numeric::Random random(7);
    Field field{.size = size, .occlusion = {}, .depth = {}, .normal = {}, .samples = {}};
    for (int i = 0; i < size.x * size.y; ++i) {
        field.occlusion.push_back(static_cast<float>(random.unit()));
        field.depth.push_back(3.0F + depth_range * static_cast<float>(random.unit()));
        const glm::vec3 tilted(0.5F * static_cast<float>(random.unit()), 0.0F, 1.0F);
        field.normal.push_back(glm::normalize(tilted));
    }
    return field;
}

// A pass along x and one along y, and how many pixels a group of either takes.
struct FilterPair {
    gpu::ComputePipeline along_x;
    gpu::ComputePipeline along_y;
    glm::uvec2 pixels_of_group;
};

// The field's occlusion after the pass along x and then along y, from a history of a format.
inline std::vector<float> run_filter(const gpu::Device& device, const FilterPair& pair, const Field& field,
                                     FilterConstants constants, gpu::Format history) {
    const gpu::Extent extent{static_cast<std::uint32_t>(field.size.x),
                             static_cast<std::uint32_t>(field.size.y)};
    using enum gpu::Format;
    gpu::Image depth(device, extent, r32f);
    gpu::Image source(device, extent, history);
    gpu::Image half(device, extent, r32f);
    gpu::Image normal(device, extent, rgba32f);
    gpu::Image result(device, extent, r32f);
    depth.upload(field.depth);
    std::vector<float> texels;
    std::vector<float> normals;
    for (std::size_t i = 0; i < field.depth.size(); ++i) {
        const float samples = field.samples.empty() ? 50.0F : field.samples[i];
        texels.insert(texels.end(), {field.occlusion[i], samples, 7.0F, field.depth[i]});
        normals.insert(normals.end(), {field.normal[i].x, field.normal[i].y, field.normal[i].z, 0.0F});
    }
    source.upload(texels);
    normal.upload(normals);
    constants.size = field.size;
    const glm::uvec2 groups = (glm::uvec2(field.size) + pair.pixels_of_group - 1U) / pair.pixels_of_group;
    const gpu::Buffer no_list(device, 128);
    gpu::Commands commands(device);
    const auto run = [&](const gpu::ComputePipeline& pass, const gpu::Image& from, const gpu::Image& to) {
        const std::vector<gpu::Resource> resources{depth, source, to, normal, no_list, from};
        commands.dispatch(pass, resources, {groups.x, groups.y, 1}, std::as_bytes(std::span(&constants, 1)));
    };
    run(pair.along_x, result, half);
    run(pair.along_y, half, result);
    commands.submit();
    return result.download();
}

}  // namespace gloam::effect
