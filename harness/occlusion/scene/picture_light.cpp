// SPDX-License-Identifier: MIT
#include "scene/picture_light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gloam::scene {
namespace {

constexpr double same_surface = 0.006;  // of the depth; as GLOAM_UPSAMPLE_TOLERANCE

void require(std::size_t found, std::size_t expected, const char* what) {
    if (found == expected) return;
    throw std::invalid_argument(fmt::format("picture light: {} {}, expected {}", found, what, expected));
}

std::size_t area(gpu::Extent extent) {
    return std::size_t{extent.width} * extent.height;
}

// Finds the pixel of a view whose surface a point shows.
class Surfaces {
  public:
    explicit Surfaces(const GBuffer& view) : view_(view), positions_(view) {}

    // x, y: the sample's own pixel. point: what the sample shows, in view space; depth: its depth, finite.
    [[nodiscard]] std::uint32_t pixel_of(std::uint32_t x, std::uint32_t y, const glm::dvec3& point,
                                         double depth) const {
        const std::uint32_t own = y * view_.extent.width + x;
        if (off_plane(own, point, depth) <= same_surface) return own;
        std::uint32_t best = own;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t row = y - std::min(y, 1U); row <= std::min(y + 1, view_.extent.height - 1);
             ++row) {
            for (std::uint32_t column = x - std::min(x, 1U);
                 column <= std::min(x + 1, view_.extent.width - 1); ++column) {
                const std::uint32_t pixel = row * view_.extent.width + column;
                const double off = off_plane(pixel, point, depth);
                if (!(off < least)) continue;
                least = off;
                best = pixel;
            }
        }
        return best;
    }

  private:
    // Distance of a point from the plane of a pixel's surface, as part of the depth; infinity: no surface.
    [[nodiscard]] double off_plane(std::uint32_t pixel, const glm::dvec3& point, double depth) const {
        if (!is_surface(view_.depth[pixel])) return std::numeric_limits<double>::infinity();
        const glm::dvec3 from = point - positions_.at(pixel, view_.depth[pixel]);
        const glm::dvec3 normal =
            view_.normal.empty() ? glm::dvec3(0, 0, 1) : glm::dvec3(view_.normal[pixel]);
        return std::abs(glm::dot(from, normal)) / depth;
    }

    const GBuffer& view_;
    PixelPositions positions_;
};

std::vector<std::uint32_t> pixels_of(const GBuffer& view, const GBuffer& fine, int samples) {
    const Surfaces surfaces(view);
    const PixelPositions positions(fine);
    const auto side = static_cast<std::uint32_t>(samples);
    std::vector<std::uint32_t> pixels;
    pixels.reserve(fine.depth.size());
    for (std::uint32_t y = 0; y < fine.extent.height; ++y) {
        for (std::uint32_t x = 0; x < fine.extent.width; ++x) {
            const float depth = fine.depth[pixels.size()];
            pixels.push_back(is_surface(depth) ? surfaces.pixel_of(x / side, y / side,
                                                                   positions.at(pixels.size(), depth), depth)
                                               : y / side * view.extent.width + x / side);
        }
    }
    return pixels;
}

}  // namespace

std::vector<float> PictureLight::spread(const std::vector<float>& of_pixels) const {
    require(of_pixels.size(), area(extent), "values");
    std::vector<float> values;
    values.reserve(pixel.size());
    for (const std::uint32_t index : pixel) values.push_back(of_pixels[index]);
    return values;
}

std::vector<glm::vec3> PictureLight::mean(const std::vector<glm::vec3>& of_samples) const {
    require(of_samples.size(), area(sampled()), "samples");
    const auto side = static_cast<std::size_t>(samples);
    std::vector<glm::vec3> means(area(extent), glm::vec3(0.0F));
    const std::size_t row = sampled().width;
    for (std::size_t i = 0; i < of_samples.size(); ++i)
        means[i / row / side * extent.width + i % row / side] += of_samples[i];
    for (glm::vec3& value : means) value /= static_cast<float>(side * side);
    return means;
}

PictureLight picture_light(const GBuffer& view, const GBuffer& fine, int samples, const Scene* scene,
                           const LightingOptions& options) {
    PictureLight picture{.extent = view.extent, .samples = samples, .light = {}, .albedo = {}, .pixel = {}};
    require(fine.depth.size(), area(picture.sampled()), "samples of the view");
    require(view.depth.size(), area(view.extent), "depths");
    if (!view.normal.empty()) require(view.normal.size(), area(view.extent), "normals");
    picture.light = light_of(fine, scene, options);
    picture.albedo =
        fine.color.empty() ? std::vector(fine.depth.size(), glm::vec3(default_color)) : fine.color;
    picture.pixel = pixels_of(view, fine, samples);
    return picture;
}

}  // namespace gloam::scene
