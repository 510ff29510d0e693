// SPDX-License-Identifier: MIT
#include "pictures/light.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/threads.hpp"
#include "scene/tracer.hpp"
#include "scene/truth.hpp"

namespace gloam::pictures {
namespace {

const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-0.55, 0.75, 0.45));  // world
constexpr double sun_radius = 0.03;                                       // of its disc, radians
constexpr double lamp_radius = 0.15;                                      // of its ball, world units
constexpr glm::dvec3 sun_color{0.60, 0.55, 0.46};
constexpr glm::dvec3 sky_above{0.50, 0.55, 0.62};
constexpr glm::dvec3 sky_horizon{0.62, 0.67, 0.73};
constexpr glm::dvec3 sky_below{0.40, 0.37, 0.33};  // light from the ground

// Where the light of a view is: its sun, or the lamp of its scene.
struct Light {
    glm::dvec3 direction{0};  // from a point to its middle, unit, view space
    double radius = 0.0;      // of its disc as seen from there, radians
    double distance = std::numeric_limits<double>::infinity();
};

// Jorge Jimenez's interleaved gradient noise: rotates the pattern of rays from pixel to pixel.
double turn_of(std::size_t pixel, std::uint32_t width) {
    const auto x = static_cast<double>(pixel % width);
    const auto y = static_cast<double>(pixel / width);
    const double inner = 0.06711056 * x + 0.00583715 * y;
    const double noise = 52.9829189 * (inner - std::floor(inner));
    return noise - std::floor(noise);
}

// Visible part of the light's disc at a point, in [0, 1]; the directions form a spiral over the disc.
double lit_part(const scene::RayScene& blockers, const Light& light, const glm::dvec3& origin,
                double clearance, int rays, double turn) {
    const glm::dvec3 middle = light.direction;
    const glm::dvec3 aside = std::abs(middle.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(aside, middle));
    const glm::dvec3 up = glm::cross(middle, right);
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    int open = 0;
    for (int i = 0; i < rays; ++i) {
        const double radius = light.radius * std::sqrt((i + 0.5) / rays);
        const double angle = golden * i + 2.0 * std::numbers::pi * turn;
        const glm::dvec3 direction =
            glm::normalize(middle + radius * (std::cos(angle) * right + std::sin(angle) * up));
        if (!blockers.first_hit(origin, direction, static_cast<float>(clearance),
                                static_cast<float>(light.distance)))
            ++open;
    }
    return static_cast<double>(open) / rays;
}

// Calculates the light of single pixels.
class Lighting {
  public:
    Lighting(const scene::GBuffer& view, const scene::Scene* scene, const LightingOptions& options)
        : view_(view),
          positions_(view),
          normals_(view.normal),
          view_from_world_(view.camera.view),
          rays_(options.rays) {
        if (normals_.empty() && std::ranges::any_of(view.depth, scene::is_surface))
            normals_ = scene::depth_field(view).normals;
        if (scene == nullptr) return;
        if (scene->lamp)
            lamp_ = view_from_world_ * (*scene->lamp - scene::camera_at(*scene, options.frame).eye);
        blockers_.emplace(scene::view_space_mesh(*scene, options.frame));
    }

    void light(std::size_t pixel, SplitLight& light) const {
        const double depth = view_.depth[pixel];
        if (!scene::is_surface(view_.depth[pixel])) {
            const glm::dvec3 away = glm::normalize(positions_.at(pixel, 1.0));
            const double up = (glm::transpose(view_from_world_) * away).y;
            light.direct[pixel] = glm::mix(sky_horizon, sky_above, std::sqrt(std::clamp(up, 0.0, 1.0)));
            return;
        }
        const glm::dvec3 albedo = view_.color.empty() ? scene::default_color : view_.color[pixel];
        const glm::dvec3 normal = normals_[pixel];
        const double up = (glm::transpose(view_from_world_) * normal).y;
        light.ambient[pixel] = albedo * glm::mix(sky_below, sky_above, 0.5 + 0.5 * up);
        light.direct[pixel] = albedo * sun_color * direct(pixel, positions_.at(pixel, depth), normal);
    }

  private:
    [[nodiscard]] Light light_at(const glm::dvec3& point) const {
        if (!lamp_) return {.direction = glm::normalize(view_from_world_ * to_sun), .radius = sun_radius};
        const double distance = glm::distance(*lamp_, point);
        return {.direction = glm::normalize(*lamp_ - point),
                .radius = lamp_radius / std::max(distance, lamp_radius),
                .distance = distance};
    }

    [[nodiscard]] double direct(std::size_t pixel, const glm::dvec3& point, const glm::dvec3& normal) const {
        const double cosine = glm::dot(normal, light_at(point).direction);
        if (!(cosine > 0.0)) return 0.0;
        if (!blockers_) return cosine;
        const double clearance = 1e-4 * scene::largest(point);  // far above the rounding error of a depth
        const glm::dvec3 origin = point + clearance * normal;
        return cosine * lit_part(*blockers_, light_at(origin), origin, clearance, rays_,
                                 turn_of(pixel, view_.extent.width));
    }

    const scene::GBuffer& view_;
    scene::PixelPositions positions_;
    std::vector<glm::vec3> normals_;
    glm::dmat3 view_from_world_;
    int rays_;
    std::optional<glm::dvec3> lamp_;  // view space; without it there is the sun
    std::optional<scene::RayScene> blockers_;
};

SplitLight light_of(const scene::GBuffer& view, const scene::Scene* scene, const LightingOptions& options) {
    const std::size_t pixels = view.depth.size();
    SplitLight light{.ambient = std::vector<glm::vec3>(pixels, glm::vec3(0)),
                     .direct = std::vector<glm::vec3>(pixels, glm::vec3(0))};
    const Lighting lighting(view, scene, options);
    const auto light_row = [&](std::size_t row) {
        for (std::size_t x = 0; x < view.extent.width; ++x)
            lighting.light(row * view.extent.width + x, light);
    };
    base::for_each_index(view.extent.height, 0, light_row, options.progress);
    return light;
}

constexpr double same_surface = 0.006;  // of the depth

// The pixel of a view whose surface a sample shows. x, y: the sample's own pixel. point: what it shows, in
// view space; depth: its depth, finite.
std::uint32_t pixel_of(const scene::GBuffer& view, const scene::PixelPositions& positions, std::uint32_t x,
                       std::uint32_t y, const glm::dvec3& point, double depth) {
    // Distance of the point from the plane of a pixel's surface, as part of the depth; infinity: no surface.
    const auto off_plane = [&](std::uint32_t pixel) {
        if (!scene::is_surface(view.depth[pixel])) return std::numeric_limits<double>::infinity();
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

std::vector<std::uint32_t> pixels_of(const scene::GBuffer& view, const scene::GBuffer& fine, int samples) {
    const scene::PixelPositions coarse(view);
    const scene::PixelPositions positions(fine);
    const auto side = static_cast<std::uint32_t>(samples);
    std::vector<std::uint32_t> pixels;
    pixels.reserve(fine.depth.size());
    for (std::uint32_t y = 0; y < fine.extent.height; ++y) {
        for (std::uint32_t x = 0; x < fine.extent.width; ++x) {
            const float depth = fine.depth[pixels.size()];
            const glm::dvec3 point = positions.at(pixels.size(), depth);
            pixels.push_back(scene::is_surface(depth)
                                 ? pixel_of(view, coarse, x / side, y / side, point, depth)
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

PictureLight picture_light(const scene::GBuffer& view, const scene::GBuffer& fine, int samples,
                           const scene::Scene* scene, const LightingOptions& options) {
    return {.extent = view.extent,
            .samples = samples,
            .light = light_of(fine, scene, options),
            .albedo = fine.color.empty() ? std::vector(fine.depth.size(), glm::vec3(scene::default_color))
                                         : fine.color,
            .pixel = pixels_of(view, fine, samples)};
}

}  // namespace gloam::pictures
