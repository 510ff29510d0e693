// SPDX-License-Identifier: MIT
#include "scene/read_gbuffer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace gloam::scene {
namespace {

constexpr double most = 0.5;  // share of the surface from which on a contradiction is reported
constexpr std::size_t too_few_pixels = 64;

// The pixels of a frame that show a surface, and their depths, ascending.
struct Surface {
    explicit Surface(const GBuffer& view) {
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            if (!is_surface(view.depth[i])) continue;
            pixels.push_back(i);
            depths.push_back(double{view.depth[i]});
        }
        std::ranges::sort(depths);
    }

    // The share of the pixels that satisfy a condition.
    template <class Condition>
    [[nodiscard]] double share(Condition condition) const {
        return static_cast<double>(std::ranges::count_if(pixels, condition)) /
               static_cast<double>(pixels.size());
    }

    std::vector<std::size_t> pixels;
    std::vector<double> depths;
};

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
            "depth {} at {}, expected depth-buffer values from 0 to 1; --depth linear reads eye-linear "
            "depth",
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

std::string values_of_no_linear_depth(const GBuffer& view, const Surface& surface) {
    const std::vector<double>& depths = surface.depths;
    constexpr double typical = 0.9;  // of a depth buffer: most is just below 1, the background is 1
    if (depths.size() == view.depth.size() && depths.back() == 1.0 && depths.front() < 1.0 &&
        depths[depths.size() / 2] > typical)
        return "no depth exceeds 1, and most lie just below it: these are values of a depth buffer, which "
               "--depth "
               "buffer reads; expected eye-linear depth";
    constexpr double rounding = 1e-3;
    const Planes planes = planes_of(view.camera.proj_vk);
    const double outside = surface.share([&](std::size_t i) {
        return view.depth[i] < (1.0 - rounding) * planes.near ||
               view.depth[i] > (1.0 + rounding) * planes.far;
    });
    if (outside <= most) return "";
    return fmt::format(
        "{} of the surface lies outside of the projection's planes, {:g} and {:g}: expected eye-linear "
        "depth in world units",
        percent(outside), planes.near, planes.far);
}

// Octahedral normals have no length of their own.
std::string lengths_that_differ(const GBuffer& view, const Surface& surface, const StoredInputs& as_stored) {
    const Encoding& encoding = as_stored.encoding;
    const auto length = [&](std::size_t i) {
        return glm::length(encoding.unorm ? 2.0F * as_stored.normal[i] - 1.0F : as_stored.normal[i]);
    };
    constexpr float tolerance = 0.05F;
    const auto differs = [&](std::size_t i) { return !(std::abs(length(i) - 1.0F) <= tolerance); };
    const double wrong = encoding.octahedral ? 0.0 : surface.share(differs);
    if (wrong <= most) return "";
    const std::size_t first = *std::ranges::find_if(surface.pixels, differs);
    return fmt::format(
        "{} of the normals have another length than 1 ({:.3g} at {}): expected unit vectors, stored as "
        "--normals says",
        percent(wrong), length(first), pixel_text(view, first));
}

// The vector between the points of two neighbours, or from the pixel to the one whose depth is nearer to its
// own.
glm::dvec3 along(const GBuffer& view, const PixelPositions& positions, std::size_t i, std::size_t step) {
    const auto point = [&](std::size_t pixel) { return positions.at(pixel, double{view.depth[pixel]}); };
    const float before = std::abs(view.depth[i] - view.depth[i - step]);
    const float behind = std::abs(view.depth[i + step] - view.depth[i]);
    return before < behind ? point(i) - point(i - step) : point(i + step) - point(i);
}

bool has_neighbours(const GBuffer& view, std::size_t i) {
    const std::size_t width = view.extent.width;
    const std::size_t x = i % width;
    const std::size_t y = i / width;
    if (x == 0 || y == 0 || x + 1 == width || y + 1 == view.extent.height) return false;
    return is_surface(view.depth[i - 1]) && is_surface(view.depth[i + 1]) &&
           is_surface(view.depth[i - width]) && is_surface(view.depth[i + width]);
}

std::string directions_that_differ(const GBuffer& view, const Surface& surface) {
    const PixelPositions positions(view);
    const auto to_eye = [&](std::size_t i) {
        return positions.orthographic() ? glm::dvec3(0, 0, 1)
                                        : -glm::normalize(positions.at(i, double{view.depth[i]}));
    };
    constexpr double grazing = -0.05;
    const double away = surface.share(
        [&](std::size_t i) { return glm::dot(glm::dvec3(view.normal[i]), to_eye(i)) < grazing; });
    if (away > most) {
        return fmt::format(
            "{} of the normals face away from the eye: expected normals in view space, which looks down "
            "-z, or in the space that --normals names",
            percent(away));
    }
    std::size_t judged = 0;
    std::size_t agree = 0;
    for (const std::size_t i : surface.pixels) {
        if (!has_neighbours(view, i)) continue;
        const glm::dvec3 across =
            glm::cross(along(view, positions, i, view.extent.width), along(view, positions, i, 1));
        const double facing = glm::dot(across, to_eye(i)) < 0.0 ? -1.0 : 1.0;  // rows may go up or down
        constexpr double same = 0.866;  // within 30 degrees: bump maps stay within it on most of a surface
        ++judged;
        if (facing * glm::dot(across, glm::dvec3(view.normal[i])) > same * glm::length(across)) ++agree;
    }
    constexpr double least = 0.25;
    const double share = static_cast<double>(agree) / static_cast<double>(std::max<std::size_t>(judged, 1));
    if (judged < too_few_pixels || share >= least) return "";
    return fmt::format(
        "only {} of the normals are within 30 degrees of the surface that the depth shows: expected depth "
        "and normals of one camera, in the spaces and encodings that --depth and --normals name",
        percent(share));
}

}  // namespace

std::string contradiction_of(const GBuffer& view, const StoredInputs& as_stored) {
    if (view.depth.size() < too_few_pixels) return "";
    const bool buffer = as_stored.encoding.depth_buffer;
    const Surface surface(view);
    std::string text = buffer ? values_of_no_depth_buffer(view, as_stored.depth) : "";
    if (!text.empty() || surface.pixels.empty()) return text;
    if (!buffer) text = values_of_no_linear_depth(view, surface);
    if (text.empty() && !view.normal.empty()) text = lengths_that_differ(view, surface, as_stored);
    if (text.empty() && !view.normal.empty()) text = directions_that_differ(view, surface);
    return text;
}

std::string radius_out_of_proportion(const GBuffer& view, double radius) {
    const Surface surface(view);
    if (surface.pixels.empty()) return "";
    const PixelPositions positions(view);
    if (positions.pixels_of_length(radius, surface.depths.front()) < 1.0) {
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
