// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/integer.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "scene/tracer.hpp"

namespace gloam::scene {

namespace {

// The weight in [0, 1] of a blocker at `distance` (>= 0) for a radius > 0 (the same unit); 0 beyond the
// radius.
double falloff_weight(Falloff falloff, double distance, double radius) {
    if (!(distance <= radius)) return 0.0;
    const double x = distance / radius;
    if (falloff == Falloff::step) return 1.0;
    return falloff == Falloff::linear ? 1.0 - x : 1.0 - x * x;
}

// Well-mixed bits of a number, the same on every machine (the finaliser of SplitMix64).
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
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

// The first points of the two-dimensional Sobol' sequence: the 32 bits of their coordinates, least
// significant first.
std::vector<glm::uvec2> sobol_points(std::size_t count) {
    std::vector<glm::uvec2> points;
    for (std::uint32_t i = 0; i < count; ++i) points.emplace_back(i, glm::bitfieldReverse(sobol_second(i)));
    return points;
}

// Such a point in (0, 1)^2 with the scrambling `seed`. Scramblings of different seeds are independent, each
// point is uniform, and the points of one seed keep the strata of the sequence: nested uniform scrambling
// (Owen), with the hash of Laine and Karras.
glm::dvec2 scrambled(const glm::uvec2& point, std::uint64_t seed) {
    const auto first = static_cast<std::uint32_t>(seed);
    const auto second = static_cast<std::uint32_t>(seed >> 32);
    return {unit_open(glm::bitfieldReverse(laine_karras(point.x, first))),
            unit_open(glm::bitfieldReverse(laine_karras(point.y, second)))};
}

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

// A direction about the z axis from a uniform point of the unit square, with density cos / pi or 1 / (2 pi).
glm::dvec3 direction_of(const glm::dvec2& u, Weighting weighting) {
    const bool cosine = weighting == Weighting::cosine;
    const double height = cosine ? std::sqrt(1.0 - u.x) : 1.0 - u.x;
    const double r = cosine ? std::sqrt(u.x) : std::sqrt(std::max(1.0 - height * height, 0.0));
    const double angle = 2.0 * std::numbers::pi * u.y;
    return {r * std::cos(angle), r * std::sin(angle), height};
}

}  // namespace

std::optional<Falloff> falloff_named(std::string_view name) {
    if (name == "linear") return Falloff::linear;
    if (name == "quadratic") return Falloff::quadratic;
    return name == "step" ? std::optional(Falloff::step) : std::nullopt;
}

void validate(const RaySettings& settings) {
    const auto fail = [](const std::string& what) { throw std::invalid_argument("truth: " + what); };
    if (!(settings.radius > 0.0)) fail("radius " + std::to_string(settings.radius) + ", expected > 0");
    if (std::isinf(settings.radius) && settings.falloff != Falloff::step)
        fail("an infinite radius needs the falloff \"step\"");
    if (settings.rays < 2 * parts || settings.rays > 1 << 24)
        fail(std::to_string(settings.rays) + " rays, expected 32 to 16777216");
}

double OcclusionTracer::part_mean(const Receiver& receiver, std::uint64_t seed) const {
    const glm::vec3 origin(receiver.position + receiver.clearance * receiver.facet);
    const auto [right, up] = tangents(receiver.normal);
    const glm::dmat3 frame(right, up, receiver.normal);
    double sum = 0.0;
    for (const glm::uvec2& point : points_) {
        glm::dvec3 direction = frame * direction_of(scrambled(point, seed), settings_.weighting);
        const double beneath = glm::dot(direction, receiver.facet);
        if (beneath < 0.0) direction -= 2.0 * beneath * receiver.facet;
        const auto hit =
            scene_.first_hit(origin, glm::vec3(direction), 0.0F, static_cast<float>(settings_.radius));
        if (hit) sum += falloff_weight(settings_.falloff, double{hit->distance}, settings_.radius);
    }
    return sum / static_cast<double>(points_.size());
}

OcclusionTracer::OcclusionTracer(const Mesh& mesh, const RaySettings& settings)
    : settings_(settings), points_(sobol_points(points_in_part(settings))), scene_(mesh) {}

std::size_t OcclusionTracer::rays() const {
    return parts * points_.size();
}

OcclusionEstimate OcclusionTracer::occlusion(const Receiver& receiver, std::uint64_t seed) const {
    std::array<double, parts> means{};
    double sum = 0.0;
    for (std::size_t part = 0; part < means.size(); ++part) {
        means[part] = part_mean(receiver, mixed(mixed(seed) + part));
        sum += means[part];
    }
    const double mean = sum / parts;
    double squares = 0.0;
    for (const double value : means) squares += (value - mean) * (value - mean);
    const double error = std::sqrt(squares / (parts * (parts - 1)));
    // If rays have weights of 0 or 1 only, parts of few rays can agree by their strata; the reported error is
    // at least that of one ray.
    const double least = settings_.falloff == Falloff::step ? 1.0 / static_cast<double>(rays()) : 0.0;
    return {std::clamp(mean, 0.0, 1.0), std::max(error, least)};
}

std::optional<Receiver> OcclusionTracer::surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                 double near, double far) const {
    const auto hit = scene_.surface(origin, direction, near, far);
    if (!hit) return std::nullopt;
    // Larger than the rounding of the ray's origin and of the intersection with neighbours in the same plane.
    return Receiver{.position = origin + hit->distance * direction,
                    .normal = hit->facet,
                    .facet = hit->facet,
                    .clearance = 4.0 * 0x1p-24 * hit->reach};
}

}  // namespace gloam::scene
