// SPDX-License-Identifier: MIT
#include "scene/gbuffer.hpp"

#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace gloam::scene {
namespace {

// Motion from within the band is invalid for the frame.
void keep_motion_inside(GBuffer& frame) {
    const PixelPositions positions(frame);
    for (std::size_t i = 0; i < frame.motion.size(); ++i)
        if (!positions.contains(glm::vec2(positions.center(i)) - glm::vec2(frame.motion[i])))
            frame.motion[i].z = 0.0F;
}

// The projection of another part of the image plane. lacks: what that part lacks to be centred, less what the
// first one does (GBuffer::off_centre).
glm::mat4 reframed(glm::mat4 projection, gpu::Extent from, gpu::Extent to, const glm::ivec2& lacks) {
    const bool orthographic = projection[2][3] == 0.0F;
    const glm::dvec2 before(from.width, from.height);
    const glm::dvec2 after(to.width, to.height);
    for (const int axis : {0, 1}) {
        float& scale = projection[axis][axis];
        float& offset = projection[orthographic ? 3 : 2][axis];
        const double moved = double{offset} * before[axis] + (orthographic ? -lacks[axis] : lacks[axis]);
        scale = static_cast<float>(double{scale} * (before[axis] / after[axis]));
        offset = static_cast<float>(moved / after[axis]);
    }
    return projection;
}

// An image with what lies around it.
template <class Texel>
void surround(std::vector<Texel>& image, gpu::Extent extent, const Border& border, const Texel& around) {
    if (image.empty()) return;
    const gpu::Extent wide = with_border(extent, border);
    std::vector<Texel> result(std::size_t{wide.width} * wide.height, around);
    for (std::size_t y = 0; y < extent.height; ++y) {
        const auto row = image.begin() + static_cast<std::ptrdiff_t>(y * extent.width);
        const std::size_t first = (y + border.top) * wide.width + border.left;
        std::copy_n(row, extent.width, result.begin() + static_cast<std::ptrdiff_t>(first));
    }
    image = std::move(result);
}

// Calls `visit(image, its value at the background)` for each image but those of GBuffer::stored.
template <class Visit>
void for_each_image(GBuffer& view, const Visit& visit) {
    constexpr float background = std::numeric_limits<float>::infinity();
    for (std::vector<float>* depths : {&view.depth, &view.previous_depth}) visit(*depths, background);
    for (std::vector<float>& layer : view.layers) visit(layer, background);
    for (auto* vectors : {&view.normal, &view.motion, &view.color, &view.previous_position})
        visit(*vectors, glm::vec3(0));
    visit(view.object, std::uint32_t{0});
}

}  // namespace

gpu::Extent guard_border(gpu::Extent frame, double guard) {
    if (!(guard >= 0.0 && guard <= 0.5))
        throw std::invalid_argument(fmt::format("guard {:g}: expected 0 to 0.5", guard));
    const auto pixels = [&](double side) {
        return static_cast<std::uint32_t>(std::floor(guard * side + 0.5));
    };
    return {pixels(frame.width), pixels(frame.height)};
}

gpu::Extent with_border(gpu::Extent frame, const Border& border) {
    return {border.left + frame.width + border.right, border.top + frame.height + border.bottom};
}

gpu::Extent frame_of(const GBuffer& view) {
    const auto inner = [](std::uint32_t side, std::uint32_t before, std::uint32_t after) {
        if (before < side && after < side - before) return side - before - after;
        throw std::invalid_argument(fmt::format(
            "guard band of {} and {} pixels: a view of {} has no frame left", before, after, side));
    };
    const Border& border = view.border;
    return {inner(view.extent.width, border.left, border.right),
            inner(view.extent.height, border.top, border.bottom)};
}

Camera with_border(const Camera& camera, gpu::Extent frame, gpu::Extent border) {
    if (border == gpu::Extent{}) return camera;
    Camera wider = camera;
    const double factor = (frame.height + 2.0 * border.height) / frame.height;  // 1 + 2 guard
    wider.fovy_rad = 2.0 * std::atan(factor * std::tan(0.5 * camera.fovy_rad));
    wider.view_height = factor * camera.view_height;
    return wider;
}

GBuffer cropped(const GBuffer& view) {
    if (view.border == Border{}) return view;
    const gpu::Extent frame = frame_of(view);
    const glm::ivec2 lacks(glm::ivec2(view.border.left, view.border.top) -
                           glm::ivec2(view.border.right, view.border.bottom));
    GBuffer inner = view;
    for_each_image(inner, [&](auto& image, const auto&) { image = cropped(view, image); });
    inner.extent = frame;
    inner.border = {};
    inner.off_centre += lacks;
    inner.stored.reset();
    inner.camera.proj_vk = reframed(view.camera.proj_vk, view.extent, frame, lacks);
    keep_motion_inside(inner);
    return inner;
}

Border centring_border(const GBuffer& view) {
    const auto lack = [](int pixels) { return static_cast<std::uint32_t>(std::max(pixels, 0)); };
    const glm::ivec2& off = view.off_centre;
    return {lack(off.x), lack(off.y), lack(-off.x), lack(-off.y)};
}

GBuffer centred(GBuffer view) {
    const Border lack = centring_border(view);
    if (lack == Border{}) return view;
    const auto widen = [&](auto& image, const auto& around) { surround(image, view.extent, lack, around); };
    if (view.stored) {
        constexpr double background = std::numeric_limits<double>::infinity();
        const double stored = stored_depth(background, view.stored->encoding, view.camera);
        widen(view.stored->depth, static_cast<float>(stored));
        widen(view.stored->normal, glm::vec3(0));
    }
    for_each_image(view, widen);
    const gpu::Extent wide = with_border(view.extent, lack);
    view.camera.proj_vk = reframed(view.camera.proj_vk, view.extent, wide, -view.off_centre);
    view.extent = wide;
    view.off_centre = glm::ivec2(0);
    const Border& band = view.border;
    view.border = {band.left + lack.left, band.top + lack.top, band.right + lack.right,
                   band.bottom + lack.bottom};
    return view;
}

namespace {

// Whether two matrices agree within rounding: of rotations, or of lengths in single precision.
bool agree(const glm::mat4& a, const glm::mat4& b) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            const float scale = 1.0F + std::abs(b[column][row]);
            if (!(std::abs(a[column][row] - b[column][row]) <= 1e-4F * scale)) return false;
        }
    }
    return true;
}

// Position of a view's point in the previous frame, from its motion. now, then: of the two views.
glm::vec3 earlier(const GBuffer& view, const PixelPositions& now, const PixelPositions& then,
                  std::size_t pixel) {
    const double depth = view.depth[pixel];
    if (!(depth > 0.0 && std::isfinite(depth))) return glm::vec3(0);
    const glm::dmat4 change(*view.camera.previous_from_current);
    const glm::dvec3 if_still(change * glm::dvec4(now.at(pixel, depth), 1.0));
    const double before = view.previous_depth.empty() ? -if_still.z : double{view.previous_depth[pixel]};
    if (!std::isfinite(before) || (!(before > 0.0) && !then.orthographic())) return glm::vec3(0);
    const glm::vec3& motion = view.motion[pixel];
    const glm::vec3 moved = then.at(pixel, before, -glm::dvec2(motion));
    // Invalid motion: the point was outside the previous image, or its position is unknown.
    if (motion.z > 0.5F || !then.contains(then.pixel_of(moved))) return moved;
    const bool left = if_still.z < 0.0 && !then.contains(then.pixel_of(if_still));
    return left ? glm::vec3(if_still) : glm::vec3(0);
}

}  // namespace

std::string cut_between(const GBuffer& previous, const GBuffer& view) {
    if (previous.extent != view.extent || previous.border != view.border) return "the size has changed";
    if (!view.camera.previous_view && !view.camera.previous_from_current) return "there is no prev_view";
    if (view.camera.previous_view && !agree(*view.camera.previous_view, previous.camera.view))
        return "prev_view is not the view before";
    return "";
}

void link(GBuffer& view, const GBuffer& previous) {
    CameraFrame& camera = view.camera;
    if (!camera.previous_from_current) {
        camera.previous_from_current =
            glm::mat4(glm::dmat4(camera.previous_view.value()) * glm::inverse(glm::dmat4(camera.view)));
    }
    if (view.motion.empty() || !view.previous_position.empty()) return;
    const PixelPositions now(view);
    const PixelPositions then(previous);
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        view.previous_position.push_back(earlier(view, now, then, i));
}

StoredInputs stored_inputs(const GBuffer& view, const Encoding& encoding) {
    StoredInputs stored{.encoding = encoding, .depth = {}, .normal = {}};
    for (const float depth : view.depth)
        stored.depth.push_back(static_cast<float>(stored_depth(double{depth}, encoding, view.camera)));
    for (const glm::vec3& normal : view.normal)
        stored.normal.emplace_back(stored_normal(glm::dvec3(normal), encoding, view.camera));
    return stored;
}

std::vector<glm::vec3> vectors_of(std::span<const float> texels, std::size_t channels) {
    std::vector<glm::vec3> vectors(texels.size() / channels);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        vectors[i] = {texels[channels * i], texels[channels * i + 1], texels[channels * i + 2]};
    return vectors;
}

}  // namespace gloam::scene
