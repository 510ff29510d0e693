// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "scene/camera.hpp"

namespace gloam::scene {

// Depth layers besides the first one.
constexpr int most_further_layers = 3;

// Depth and normals as an engine stores them.
struct StoredInputs {
    Encoding encoding;
    std::vector<float> depth;
    std::vector<glm::vec3> normal;  // empty if the engine has none
};

// Pixels of an image around the frame in it, on each side.
struct Border {
    std::uint32_t left = 0;
    std::uint32_t top = 0;
    std::uint32_t right = 0;
    std::uint32_t bottom = 0;

    Border() = default;
    Border(std::uint32_t l, std::uint32_t t, std::uint32_t r, std::uint32_t b)
        : left(l), top(t), right(r), bottom(b) {}
    // The same on the left and right (width), and at top and bottom (height).
    Border(backend::Extent each)  // NOLINT(google-explicit-constructor)
        : Border(each.width, each.height, each.width, each.height) {}

    // What two opposite sides have in common.
    [[nodiscard]] backend::Extent each_side() const { return {std::min(left, right), std::min(top, bottom)}; }

    friend bool operator==(const Border&, const Border&) = default;
};

// The input of an ambient-occlusion effect from an engine: one frame, rows from the top. Each image has width
// * height elements, or is empty.
struct GBuffer {
    backend::Extent extent;
    std::vector<float> depth;       // eye-linear, world units; background +infinity
    std::vector<glm::vec3> normal;  // view space, unit, to the viewer; background 0. Empty: from the depth
    std::vector<glm::vec3> motion;  // dx, dy in pixels (y down), valid. Empty: from the cameras alone
    // With motion: eye-linear depth of the surface point in the camera of the frame before. Empty: from the
    // cameras.
    std::vector<float> previous_depth;
    // Surfaces behind depth, nearest first, at most most_further_layers of them: eye-linear depth, negative
    // for a surface seen from behind, which ends the solid in front of it. Not finite: no further surface.
    std::vector<std::vector<float>> layers;
    std::vector<glm::vec3> color;  // diffuse albedo, linear, [0, 1]. Empty: white
    CameraFrame camera;
    std::optional<double> ao_radius;  // world units
    Border border;  // around the frame, part of extent: a guard band, and background that centred() adds
    // Pixels that the image lacks on the left and at the top to have the camera's axis in its middle;
    // negative: on the right and at the bottom. Besides, the axis is off the middle by a jitter, which is
    // ignored.
    glm::ivec2 off_centre{0};

    // Depth and normals again, as the engine stores them: the effect converts these on the device.
    std::optional<StoredInputs> stored;

    // From draw(); previous_position on request, and from link().
    std::vector<glm::vec3> previous_position;  // in the view space of the frame before; background 0
    std::vector<std::uint32_t> object;         // 0: static, k: the k-th moving object; background 0
};

// A guard band (TSSAO-BORDER): the view is rendered larger, so that surfaces near the frame's edge have
// neighbours, and the result is cropped. The band is a whole number of pixels on each side, and the larger
// projection follows from these pixels. The frame's pixels therefore have the same view rays as without a
// band.

// The band in pixels, on the left and right (width) and at top and bottom (height): guard times each side of
// the frame, rounded to the nearest pixel, halves up. guard: 0 to 0.5; usual values are 0.05 to 0.1.
[[nodiscard]] backend::Extent guard_border(backend::Extent frame, double guard);

// The size of the frame with its band.
[[nodiscard]] backend::Extent with_border(backend::Extent frame, const Border& border);

// The size of a view without its band. Throws std::invalid_argument for a band that leaves no pixel.
[[nodiscard]] backend::Extent frame_of(const GBuffer& view);

// The camera of the larger view: tan(fov'/2) = (1 + 2 border / frame) tan(fov/2) along each axis. Its aspect
// is that of with_border().
[[nodiscard]] Camera with_border(const Camera& camera, backend::Extent frame, backend::Extent border);

// A window of an image, from its pixel `first` on; `around` where it reaches beyond the image.
template <class Texel>
[[nodiscard]] std::vector<Texel> window_of(const std::vector<Texel>& image, backend::Extent extent,
                                           const glm::ivec2& first, backend::Extent window,
                                           const Texel& around = {}) {
    std::vector<Texel> inner(image.empty() ? 0 : std::size_t{window.width} * window.height, around);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const glm::ivec2 at = glm::ivec2(i % extent.width, i / extent.width) - first;
        if (at.x >= 0 && at.y >= 0 && at.x < int(window.width) && at.y < int(window.height))
            inner[static_cast<std::size_t>(at.y) * window.width + static_cast<std::size_t>(at.x)] = image[i];
    }
    return inner;
}

// The pixels of an image of `view` that belong to the frame.
template <class Texel>
[[nodiscard]] std::vector<Texel> cropped(const GBuffer& view, const std::vector<Texel>& image) {
    const backend::Extent frame = frame_of(view);
    if (frame == view.extent) return image;
    return window_of(image, view.extent, {view.border.left, view.border.top}, frame);
}

// The frame without its band: cropped images, projection, and motion that is valid only if it began in the
// frame. A view without a band is returned unchanged.
[[nodiscard]] GBuffer cropped(const GBuffer& view);

// The passes take cameras whose axis is in the middle of the image. An image with another (one eye of a
// headset, a tile, a split screen) becomes part of one that has: centring_border() is what it lacks for that,
// on one side along each axis, and centred() fills it with background and adds it to the border.
[[nodiscard]] Border centring_border(const GBuffer& view);
[[nodiscard]] GBuffer centred(GBuffer view);

// Whether an eye-linear depth is that of a surface, not of the background.
[[nodiscard]] inline bool is_surface(float depth) {
    return depth > 0.0F && std::isfinite(depth);
}

// Conversion of pixels to view-space positions and back, in double.
class PixelPositions {
  public:
    explicit PixelPositions(const GBuffer& view)
        : width_(view.extent.width),
          size_(view.extent.width, view.extent.height),
          scale_(view.camera.p00_p11()),
          off_centre_(view.off_centre),
          orthographic_(view.camera.orthographic()) {}

    // The centre of a pixel in the image, and whether a place is in it.
    [[nodiscard]] glm::dvec2 center(std::size_t pixel) const {
        return {static_cast<double>(pixel % width_) + 0.5, static_cast<double>(pixel / width_) + 0.5};
    }
    [[nodiscard]] bool contains(const glm::dvec2& place) const {
        return place.x >= 0.0 && place.y >= 0.0 && place.x < size_.x && place.y < size_.y;
    }

    // The point at an eye-linear depth under the centre of a pixel; pixels are counted by rows from the top.
    // aside: offset from the centre, pixels.
    [[nodiscard]] glm::dvec3 at(std::size_t pixel, double depth, const glm::dvec2& aside = {0, 0}) const {
        const glm::dvec2 ndc = (2.0 * (center(pixel) + aside) + off_centre_) / size_ - 1.0;
        return {ndc / scale_ * (orthographic_ ? 1.0 : depth), -depth};
    }

    // The view ray through the centre of a pixel. Its direction is 1 long along the view axis, so that
    // distances are depths.
    struct Ray {
        glm::dvec3 origin;
        glm::dvec3 direction;
    };
    [[nodiscard]] Ray ray(std::size_t pixel, const glm::dvec2& aside = {0, 0}) const {
        const glm::dvec3 first = at(pixel, 1.0, aside);
        return orthographic_ ? Ray{{first.x, first.y, 0}, {0, 0, -1}} : Ray{{0, 0, 0}, first};
    }

    // Position of a view-space point in the image, in pixels from the top left corner; the centre of the
    // first pixel is (0.5, 0.5). Perspective: only for points in front of the eye (z < 0).
    [[nodiscard]] glm::dvec2 pixel_of(const glm::dvec3& position) const {
        const glm::dvec2 ndc = scale_ * glm::dvec2(position) / (orthographic_ ? 1.0 : -position.z);
        return (0.5 * ndc + 0.5) * size_ - 0.5 * off_centre_;
    }

    // Number of pixels that a length parallel to the image covers at a depth.
    [[nodiscard]] double pixels_of_length(double length, double depth) const {
        return 0.5 * length * glm::abs(scale_.y) * size_.y / (orthographic_ ? 1.0 : depth);
    }

    [[nodiscard]] bool orthographic() const { return orthographic_; }

  private:
    std::size_t width_;
    glm::dvec2 size_;
    glm::dvec2 scale_;
    glm::dvec2 off_centre_;
    bool orthographic_;
};

// The reason why a history cannot be followed from one view to the next: "the size has changed", "there is no
// prev_view", "prev_view is not the view before". Empty: it can.
[[nodiscard]] std::string cut_between(const GBuffer& previous, const GBuffer& view);

// Completes a view that was read from files, as draw() would: previous_from_current from the matrices if
// it is missing, and previous_position from the motion vectors if there are any. The earlier depth of a point
// is previous_depth if given. Otherwise it follows from the cameras, which is right for static objects and
// for objects that do not move towards the eye.
// If motion is invalid and leads into the previous image, the position is 0: no history. Without motion
// vectors the cameras alone are used, for a static scene. Existing values are kept. Requires that
// cut_between() returns "".
void link(GBuffer& view, const GBuffer& previous);

// The first three channels of each texel.
[[nodiscard]] std::vector<glm::vec3> vectors_of(std::span<const float> texels, std::size_t channels = 4);

// Depth and normals of a view as an engine with this encoding stores them.
[[nodiscard]] StoredInputs stored_inputs(const GBuffer& view, const Encoding& encoding);

}  // namespace gloam::scene
