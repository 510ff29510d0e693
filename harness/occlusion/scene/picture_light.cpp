// SPDX-License-Identifier: MIT
#include "scene/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::scene {
namespace {

constexpr double same_surface = 0.006;  // of the depth; as GLOAM_UPSAMPLE_TOLERANCE

// The pixel of a view whose surface a sample shows. x, y: the sample's own pixel. point: what it shows, in
// view space; depth: its depth, finite.
std::uint32_t pixel_of(const GBuffer& view, const PixelPositions& positions, std::uint32_t x, std::uint32_t y,
                       const glm::dvec3& point, double depth) {
    // Distance of the point from the plane of a pixel's surface, as part of the depth; infinity: no surface.
    const auto off_plane = [&](std::uint32_t pixel) {
        if (!is_surface(view.depth[pixel])) return std::numeric_limits<double>::infinity();
        const glm::dvec3 from = point - positions.at(pixel, view.depth[pixel]);
        const glm::dvec3 normal = view.normal.empty() ? glm::dvec3(0, 0, 1) : glm::dvec3(view.normal[pixel]);
        return std::abs(glm::dot(from, normal)) / depth;
    };
    const auto [width, height] = view.extent;
    const std::uint32_t own = y * width + x;
    if (off_plane(own) <= same_surface) return own;
    std::uint32_t best = own;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t row = y - std::min(y, 1U); row <= std::min(y + 1, height - 1); ++row) {
        for (std::uint32_t column = x - std::min(x, 1U); column <= std::min(x + 1, width - 1); ++column) {
            const double off = off_plane(row * width + column);
            if (!(off < least)) continue;
            least = off;
            best = row * width + column;
        }
    }
    return best;
}

std::vector<std::uint32_t> pixels_of(const GBuffer& view, const GBuffer& fine, int samples) {
    const PixelPositions coarse(view);
    const PixelPositions positions(fine);
    const auto side = static_cast<std::uint32_t>(samples);
    std::vector<std::uint32_t> pixels;
    pixels.reserve(fine.depth.size());
    for (std::uint32_t y = 0; y < fine.extent.height; ++y) {
        for (std::uint32_t x = 0; x < fine.extent.width; ++x) {
            const float depth = fine.depth[pixels.size()];
            const glm::dvec3 point = positions.at(pixels.size(), depth);
            pixels.push_back(is_surface(depth) ? pixel_of(view, coarse, x / side, y / side, point, depth)
                                               : y / side * view.extent.width + x / side);
        }
    }
    return pixels;
}

}  // namespace

std::vector<float> PictureLight::spread(const std::vector<float>& of_pixels) const {
    std::vector<float> values;
    values.reserve(pixel.size());
    for (const std::uint32_t index : pixel) values.push_back(of_pixels[index]);
    return values;
}

std::vector<glm::vec3> PictureLight::mean(const std::vector<glm::vec3>& of_samples) const {
    const auto side = static_cast<std::size_t>(samples);
    std::vector<glm::vec3> means(std::size_t{extent.width} * extent.height, glm::vec3(0.0F));
    const std::size_t row = sampled().width;
    for (std::size_t i = 0; i < of_samples.size(); ++i)
        means[i / row / side * extent.width + i % row / side] += of_samples[i];
    for (glm::vec3& value : means) value /= static_cast<float>(side * side);
    return means;
}

PictureLight picture_light(const GBuffer& view, const GBuffer& fine, int samples, const Scene* scene,
                           const LightingOptions& options) {
    return {
        .extent = view.extent,
        .samples = samples,
        .light = light_of(fine, scene, options),
        .albedo = fine.color.empty() ? std::vector(fine.depth.size(), glm::vec3(default_color)) : fine.color,
        .pixel = pixels_of(view, fine, samples)};
}

}  // namespace gloam::scene
