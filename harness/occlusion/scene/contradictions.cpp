// SPDX-License-Identifier: MIT
#include "scene/read_gbuffer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

namespace gloam::scene {
namespace {

constexpr double most = 0.5;  // share of the surface from which on a contradiction is reported
constexpr std::size_t too_few_pixels = 64;

// The pixels of a frame that show a surface, and their depths, ascending.
struct Surface {
    explicit Surface(const GBuffer& of) : view(of), positions(of) {
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            if (!is_surface(view.depth[i])) continue;
            pixels.push_back(i);
            depths.push_back(double{view.depth[i]});
        }
        std::ranges::sort(depths);
        std::ranges::copy_if(pixels, std::back_inserter(inner), [&](std::size_t i) {
            const std::size_t width = view.extent.width;
            const std::size_t x = i % width;
            const std::size_t y = i / width;
            return x > 0 && y > 0 && x + 1 < width && y + 1 < view.extent.height &&
                   is_surface(view.depth[i - 1]) && is_surface(view.depth[i + 1]) &&
                   is_surface(view.depth[i - width]) && is_surface(view.depth[i + width]);
        });
    }

    const GBuffer& view;
    PixelPositions positions;
    std::vector<std::size_t> pixels;
    std::vector<std::size_t> inner;  // those between four that show surfaces, too
    std::vector<double> depths;
};

// The share of the pixels that satisfy a condition; 0 of none.
template <class Condition>
double share(const std::vector<std::size_t>& pixels, Condition condition) {
    return static_cast<double>(std::ranges::count_if(pixels, condition)) /
           static_cast<double>(std::max<std::size_t>(pixels.size(), 1));
}

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100.0 * share);
}

std::string pixel_text(const GBuffer& view, std::size_t pixel) {
    return fmt::format("pixel ({}, {})", pixel % view.extent.width, pixel / view.extent.width);
}

std::string values_of_no_depth_buffer(const GBuffer& view, const std::vector<float>& stored) {
    const auto outside = std::ranges::find_if(stored, [](float b) { return b < 0.0F || b > 1.0F; });
    if (outside != stored.end()) {
        return fmt::format(
            "depth {} at {}, expected depth-buffer values from 0 to 1; --depth linear reads eye-linear depth",
            *outside, pixel_text(view, static_cast<std::size_t>(outside - stored.begin())));
    }
    const bool reversed = planes_of(view.camera.proj_vk).reversed_z;
    const auto on_near = static_cast<double>(std::ranges::count(stored, reversed ? 1.0F : 0.0F));
    constexpr double few = 0.01;  // no surface lies exactly on the near plane
    if (on_near <= few * static_cast<double>(stored.size())) return "";
    return fmt::format(
        "{} of the depth buffer lies on the near plane of a projection whose Z is {}reversed: expected a "
        "projection and a buffer of one kind",
        percent(on_near / static_cast<double>(stored.size())), reversed ? "" : "not ");
}

std::string values_of_no_linear_depth(const Surface& surface) {
    const GBuffer& view = surface.view;
    const std::vector<double>& depths = surface.depths;
    constexpr double typical = 0.9;  // of a depth buffer: most is just below 1, the background is 1
    if (depths.size() == view.depth.size() && depths.back() == 1.0 && depths.front() < 1.0 &&
        depths[depths.size() / 2] > typical)
        return "no depth exceeds 1, and most lie just below it: these are values of a depth buffer, which "
               "--depth buffer reads; expected eye-linear depth";
    constexpr double rounding = 1e-3;
    const Planes planes = planes_of(view.camera.proj_vk);
    const double outside = share(surface.pixels, [&](std::size_t i) {
        return view.depth[i] < (1.0 - rounding) * planes.near ||
               view.depth[i] > (1.0 + rounding) * planes.far;
    });
    if (outside <= most) return "";
    return fmt::format(
        "{} of the surface lies outside of the projection's planes, {:g} and {:g}: expected eye-linear depth "
        "in world units",
        percent(outside), planes.near, planes.far);
}

// Octahedral normals have no length of their own.
std::string lengths_that_differ(const Surface& surface, const StoredInputs& as_stored) {
    const Encoding& encoding = as_stored.encoding;
    const auto length = [&](std::size_t i) {
        return glm::length(encoding.unorm ? 2.0F * as_stored.normal[i] - 1.0F : as_stored.normal[i]);
    };
    constexpr float tolerance = 0.05F;
    const auto differs = [&](std::size_t i) { return !(std::abs(length(i) - 1.0F) <= tolerance); };
    const double wrong = encoding.octahedral ? 0.0 : share(surface.pixels, differs);
    if (wrong <= most) return "";
    const std::size_t first = *std::ranges::find_if(surface.pixels, differs);
    return fmt::format(
        "{} of the normals have another length than 1 ({:.3g} at {}): expected unit vectors, stored as "
        "--normals says",
        percent(wrong), length(first), pixel_text(surface.view, first));
}

// The vector between the points of two neighbours, or from the pixel to the one whose depth is nearer to its
// own. radial: what is stored as depth is the distance to the eye.
glm::dvec3 along(const Surface& surface, std::size_t i, std::size_t step, bool radial) {
    const GBuffer& view = surface.view;
    const auto point = [&](std::size_t pixel) {
        const double length = radial ? glm::length(surface.positions.ray(pixel).direction) : 1.0;
        return surface.positions.at(pixel, double{view.depth[pixel]} / length);
    };
    const float before = std::abs(view.depth[i] - view.depth[i - step]);
    const float behind = std::abs(view.depth[i + step] - view.depth[i]);
    return before < behind ? point(i) - point(i - step) : point(i + step) - point(i);
}

// The normal that the depth shows, towards the eye.
glm::dvec3 normal_by_depth(const Surface& surface, std::size_t i, bool radial = false) {
    const glm::dvec3 across =
        glm::cross(along(surface, i, surface.view.extent.width, radial), along(surface, i, 1, radial));
    return glm::normalize(glm::faceforward(across, surface.positions.ray(i).direction, across));
}

// Depth that is the distance to the eye bends every surface, at the sides of an image by degrees. Pixels
// where the two meanings of depth are so far apart are judged: a normal tells one of them that is near to it,
// and half as far as from the other.
std::string distances_to_the_eye(const Surface& surface) {
    if (surface.positions.orthographic()) return "";
    constexpr double apart = 0.035;  // 2 degrees
    constexpr double near = 0.175;   // 10 degrees
    std::size_t judged = 0;
    std::size_t linear = 0;
    std::size_t radial = 0;
    for (const std::size_t i : surface.inner) {
        const glm::dvec3 normal(surface.view.normal[i]);
        if (normal == glm::dvec3(0)) continue;
        const glm::dvec3 first = normal_by_depth(surface, i);
        const glm::dvec3 second = normal_by_depth(surface, i, true);
        if (!(glm::distance(first, second) > apart)) continue;
        ++judged;
        const double to_first = glm::distance(normal, first);
        const double to_second = glm::distance(normal, second);
        if (to_first < near && to_first < 0.5 * to_second) ++linear;
        if (to_second < near && to_second < 0.5 * to_first) ++radial;
    }
    const double told = static_cast<double>(radial) / static_cast<double>(std::max<std::size_t>(judged, 1));
    constexpr double least = 0.25;
    if (judged < too_few_pixels || told < least || radial < 4 * linear) return "";
    return fmt::format(
        "by {} of the normals the depth is the distance to the eye: expected eye-linear depth, the distance "
        "along -z",
        percent(told));
}

std::string directions_that_differ(const Surface& surface) {
    const auto normal = [&](std::size_t i) { return glm::dvec3(surface.view.normal[i]); };
    constexpr double grazing = 0.05;
    const double away = share(surface.pixels, [&](std::size_t i) {
        return glm::dot(normal(i), glm::normalize(surface.positions.ray(i).direction)) > grazing;
    });
    if (away > most) {
        return fmt::format(
            "{} of the normals face away from the eye: expected normals in view space, which looks down -z, "
            "or in the space that --normals names",
            percent(away));
    }
    constexpr double same = 0.866;  // within 30 degrees: bump maps stay within it on most of a surface
    constexpr double least = 0.25;
    const double agree = share(surface.inner, [&](std::size_t i) {
        return glm::dot(normal_by_depth(surface, i), normal(i)) > same;
    });
    if (surface.inner.size() < too_few_pixels || agree >= least) return "";
    return fmt::format(
        "only {} of the normals are within 30 degrees of the surface that the depth shows: expected depth "
        "and normals of one camera, in the spaces and encodings that --depth and --normals name",
        percent(agree));
}

// From one value that an engine can store as depth to the next: of floats, or where all values are halves or,
// in a depth buffer, whole numbers of some bits that stand for 0 to 1, of these.
class Spacing {
  public:
    Spacing(const std::vector<float>& stored, const Surface& surface, bool buffer) {
        std::set<float> values;
        for (const std::size_t i : surface.pixels) values.insert(stored[i]);
        const auto zeros = [](float x) { return std::countr_zero(std::bit_cast<std::uint32_t>(x)); };
        constexpr int cut = 13;  // bits that floats have and halves do not
        halves_ = values.size() > 3 && zeros(std::ranges::min(values, {}, zeros)) == cut;
        for (int bits = 8; buffer && !halves_ && bits <= 24 && whole_ == 0.0; ++bits) {
            const double largest = std::exp2(bits) - 1.0;
            const auto is_whole = [&](float x) {  // but for the rounding to a float
                const double number = x * largest;
                return std::abs(number - std::round(number)) <= 0.5 * largest * spacing(x, 23);
            };
            const bool chance = values.size() * static_cast<std::size_t>(24 - bits) < 16 && bits < 24;
            if (!chance && std::ranges::all_of(values, is_whole)) whole_ = 1.0 / largest;
        }
    }
    [[nodiscard]] double at(float value) const { return std::max(whole_, spacing(value, halves_ ? 10 : 23)); }

  private:
    // Of binary numbers with so many bits behind the first.
    static double spacing(float value, int bits) { return std::exp2(std::logb(double{value}) - bits); }

    bool halves_ = false;
    double whole_ = 0.0;
};

}  // namespace

std::string contradiction_of(const GBuffer& view, const StoredInputs& as_stored) {
    if (view.depth.size() < too_few_pixels) return "";
    const bool buffer = as_stored.encoding.depth_buffer;
    const Surface surface(view);
    std::string text = buffer ? values_of_no_depth_buffer(view, as_stored.depth) : "";
    if (!text.empty() || surface.pixels.empty()) return text;
    if (!buffer) text = values_of_no_linear_depth(surface);
    if (view.normal.empty()) return text;
    if (text.empty()) text = lengths_that_differ(surface, as_stored);
    if (text.empty() && !buffer) text = distances_to_the_eye(surface);
    if (text.empty()) text = directions_that_differ(surface);
    return text;
}

std::string too_coarse_steps(const GBuffer& view, double radius) {
    const Surface surface(view);
    if (surface.pixels.empty()) return "";
    const bool buffer = view.stored && view.stored->encoding.depth_buffer;
    const std::vector<float>& stored = view.stored ? view.stored->depth : view.depth;
    const Spacing spacing(stored, surface, buffer);
    const glm::dmat4 projection(view.camera.proj_vk);
    const auto is_coarse = [&](std::size_t i) {
        const double depth = view.depth[i];
        const double rise = !buffer                      ? 1.0
                            : view.camera.orthographic() ? 1.0 / projection[2][2]
                                                         : depth * depth / projection[3][2];
        return spacing.at(stored[i]) * std::abs(rise) > 0.1 * radius;
    };
    const double coarse = share(surface.pixels, is_coarse);
    if (coarse <= most) return "";
    const Planes planes = planes_of(view.camera.proj_vk);
    return fmt::format(
        "at {} of the surface one step of the stored depth is more than a tenth of the radius, {:g}: near "
        "{:g} and far {:g} leave too few steps; expected a farther near plane, reversed Z in floats, or "
        "depth of more bits",
        percent(coarse), radius, planes.near, planes.far);
}

std::string radius_out_of_proportion(const GBuffer& view, double radius) {
    const Surface surface(view);
    if (surface.pixels.empty()) return "";
    if (surface.positions.pixels_of_length(radius, surface.depths.front()) < 1.0) {
        return fmt::format(
            "radius {:g}: it is below a pixel at the nearest surface, {:g} away, so nothing is occluded",
            radius, surface.depths.front());
    }
    constexpr double largest = 1e3;
    if (radius <= largest * surface.depths.back()) return "";
    return fmt::format(
        "radius {:g}: the farthest surface is {:g} away, expected a radius of the size of the scene's "
        "features",
        radius, surface.depths.back());
}

}  // namespace gloam::scene
