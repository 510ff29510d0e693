// SPDX-License-Identifier: MIT
#include "scene/occlusion_tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "scene/internal/ray_scene.hpp"

namespace gloam::scene {

double falloff_weight(Falloff falloff, double distance, double radius) {
    if (!(distance <= radius)) return 0.0;
    const double x = distance / radius;
    switch (falloff) {
        case Falloff::linear:
            return 1.0 - x;
        case Falloff::quadratic:
            return 1.0 - x * x;
        case Falloff::step:
            return 1.0;
    }
    return 0.0;
}

const char* name_of(Falloff falloff) {
    switch (falloff) {
        case Falloff::linear:
            return "linear";
        case Falloff::quadratic:
            return "quadratic";
        case Falloff::step:
            return "step";
    }
    return "";
}

std::optional<Falloff> falloff_named(std::string_view name) {
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::step}) {
        if (name == name_of(falloff)) return falloff;
    }
    return std::nullopt;
}

namespace {

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
    x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
    x = (x & 0x0f0f0f0fU) << 4 | (x >> 4 & 0x0f0f0f0fU);
    x = (x & 0x00ff00ffU) << 8 | (x >> 8 & 0x00ff00ffU);
    return x << 16 | x >> 16;
}

// The second coordinate. The first is the index with its bits reversed.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 1U << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
        if ((index & 1U) != 0) bits ^= direction;
    }
    return bits;
}

// A hash flips each bit of x depending on the bits below it only. With the bits reversed this is a nested
// scrambling.
constexpr std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

double unit_open(std::uint32_t bits) {
    return (static_cast<double>(bits) + 0.5) * 0x1p-32;
}

}  // namespace

SobolPoints::SobolPoints(std::size_t count) {
    reversed_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) reversed_.push_back({i, reversed(sobol_second(i))});
}

glm::dvec2 SobolPoints::scrambled(std::size_t index, std::uint64_t seed) const {
    const Bits bits = reversed_[index];
    const auto first = static_cast<std::uint32_t>(seed);
    const auto second = static_cast<std::uint32_t>(seed >> 32);
    return {unit_open(reversed(laine_karras(bits.x, first))),
            unit_open(reversed(laine_karras(bits.y, second)))};
}

namespace {

// Number of independent scramblings; their means give the standard error.
constexpr int parts = 16;

std::size_t points_in_part(const RaySettings& settings) {
    validate(settings);
    return static_cast<std::size_t>((settings.rays + parts - 1) / parts);
}

// Two unit vectors at right angles to a unit vector and to each other (Duff et al. 2017).
std::array<glm::dvec3, 2> tangents(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {glm::dvec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            glm::dvec3(b, sign + n.y * n.y * a, -n.y)};
}

// A direction with density cos / pi about the z axis, from a uniform point of the unit square.
glm::dvec3 cosine_direction(const glm::dvec2& u) {
    const double r = std::sqrt(u.x);
    const double angle = 2.0 * std::numbers::pi * u.y;
    return {r * std::cos(angle), r * std::sin(angle), std::sqrt(1.0 - u.x)};
}

// The same with density 1 / (2 pi).
glm::dvec3 uniform_direction(const glm::dvec2& u) {
    const double height = 1.0 - u.x;
    const double r = std::sqrt(std::max(1.0 - height * height, 0.0));
    const double angle = 2.0 * std::numbers::pi * u.y;
    return {r * std::cos(angle), r * std::sin(angle), height};
}

// The directions of one part, in the frame of the receiver.
class Directions {
  public:
    Directions(const Receiver& receiver, Weighting weighting)
        : weighting_(weighting),
          facet_(receiver.facet),
          frame_(tangents(receiver.normal)[0], tangents(receiver.normal)[1], receiver.normal) {}

    [[nodiscard]] glm::vec3 at(const glm::dvec2& u) const {
        glm::dvec3 direction =
            frame_ * (weighting_ == Weighting::cosine ? cosine_direction(u) : uniform_direction(u));
        const double beneath = glm::dot(direction, facet_);
        if (beneath < 0.0) direction -= 2.0 * beneath * facet_;
        return {direction};
    }

  private:
    Weighting weighting_;
    glm::dvec3 facet_;
    glm::dmat3 frame_;
};

}  // namespace

void validate(const RaySettings& settings) {
    const auto fail = [](const std::string& what) { throw std::invalid_argument("truth: " + what); };
    if (!(settings.radius > 0.0)) fail("radius " + std::to_string(settings.radius) + ", expected > 0");
    if (std::isinf(settings.radius) && settings.falloff != Falloff::step)
        fail("an infinite radius needs the falloff \"step\"");
    if (settings.rays < 2 * parts || settings.rays > 1 << 24)
        fail(std::to_string(settings.rays) + " rays, expected 32 to 16777216");
}

struct OcclusionTracer::Impl {
    RaySettings settings;
    SobolPoints points;
    RayScene scene;

    // The mean weight over the rays of one part.
    [[nodiscard]] double part_mean(const glm::vec3& origin, const Directions& directions,
                                   std::uint64_t seed) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto hit = scene.first_hit(origin, directions.at(points.scrambled(i, seed)), 0.0F,
                                             static_cast<float>(settings.radius));
            if (hit) sum += falloff_weight(settings.falloff, double{hit->distance}, settings.radius);
        }
        return sum / static_cast<double>(points.size());
    }
};

OcclusionTracer::OcclusionTracer(Mesh mesh, const RaySettings& settings)
    : impl_(base::make_hidden<Impl>(Impl{settings, SobolPoints(points_in_part(settings)),
                                         RayScene(std::move(mesh.positions), std::move(mesh.indices))})) {}

std::size_t OcclusionTracer::rays() const {
    return parts * impl_->points.size();
}

OcclusionEstimate OcclusionTracer::occlusion(const Receiver& receiver, std::uint64_t seed) const {
    const glm::vec3 origin(receiver.position + receiver.clearance * receiver.facet);
    const Directions directions(receiver, impl_->settings.weighting);
    std::array<double, parts> means{};
    double sum = 0.0;
    for (std::size_t part = 0; part < means.size(); ++part) {
        means[part] = impl_->part_mean(origin, directions, mixed(mixed(seed) + part));
        sum += means[part];
    }
    const double mean = sum / parts;
    double squares = 0.0;
    for (const double value : means) squares += (value - mean) * (value - mean);
    const double error = std::sqrt(squares / (parts * (parts - 1)));
    // If rays have weights of 0 or 1 only, parts of few rays can agree by their strata; the reported error is
    // at least that of one ray.
    const double least = impl_->settings.falloff == Falloff::step ? 1.0 / static_cast<double>(rays()) : 0.0;
    return {std::clamp(mean, 0.0, 1.0), std::max(error, least)};
}

std::optional<Receiver> OcclusionTracer::surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                 double near, double far) const {
    const auto hit = impl_->scene.surface(origin, direction, near, far);
    if (!hit) return std::nullopt;
    const auto [a, b, c] = impl_->scene.corners(hit->triangle);
    const glm::dvec3 at = origin + hit->distance * direction;
    // Larger than the rounding of the ray's origin and of the intersection with neighbours in the same plane.
    const double reach = std::max({largest(at), largest(b - a), largest(c - a)});
    return Receiver{
        .position = at, .normal = hit->facet, .facet = hit->facet, .clearance = 4.0 * 0x1p-24 * reach};
}

}  // namespace gloam::scene
