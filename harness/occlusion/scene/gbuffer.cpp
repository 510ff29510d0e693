// SPDX-License-Identifier: MIT
#include "scene/gbuffer.hpp"

#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace gloam::scene {
namespace {

// The view in a window that is larger by these pixels on the left, at the top, on the right and at the
// bottom, with background in them; smaller where they are negative.
GBuffer in_window(GBuffer view, const glm::ivec4& more) {
    const backend::Extent from = view.extent;
    const glm::ivec2 before(more.x, more.y);
    const glm::ivec2 behind(more.z, more.w);
    const glm::ivec2 size = glm::ivec2(from.width, from.height) + before + behind;
    view.extent = {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
    const auto reframe = [&](auto& image, const auto& around) {
        image = window_of(image, from, -before, view.extent, around);
    };
    constexpr float background = std::numeric_limits<float>::infinity();
    const glm::vec3 none(0);
    for (std::vector<float>* depths : {&view.depth, &view.previous_depth}) reframe(*depths, background);
    for (std::vector<float>& layer : view.layers) reframe(layer, background);
    for (auto* vectors : {&view.normal, &view.motion, &view.color, &view.previous_position})
        reframe(*vectors, none);
    reframe(view.object, std::uint32_t{0});
    if (view.stored) {
        const double far = stored_depth(double{background}, view.stored->encoding, view.camera);
        reframe(view.stored->depth, static_cast<float>(far));
        reframe(view.stored->normal, none);
    }
    glm::mat4& projection = view.camera.proj_vk;
    const bool orthographic = view.camera.orthographic();
    for (const int axis : {0, 1}) {
        const double sides[] = {double(axis == 0 ? from.width : from.height), double(size[axis])};
        const int lacks = behind[axis] - before[axis];
        float& scale = projection[axis][axis];
        float& offset = projection[orthographic ? 3 : 2][axis];
        const double moved = double{offset} * sides[0] + (orthographic ? -lacks : lacks);
        scale = static_cast<float>(double{scale} * (sides[0] / sides[1]));
        offset = static_cast<float>(moved / sides[1]);
    }
    view.off_centre += behind - before;
    const auto side = [](std::uint32_t band, int by) {
        return static_cast<std::uint32_t>(static_cast<int>(band) + by);
    };
    view.border = {side(view.border.left, more.x), side(view.border.top, more.y),
                   side(view.border.right, more.z), side(view.border.bottom, more.w)};
    return view;
}

// Whether two matrices agree within rounding: of rotations, or of lengths in single precision.
bool agree(const glm::mat4& a, const glm::mat4& b) {
    for (int i = 0; i < 4; ++i)
        if (!glm::all(glm::lessThanEqual(glm::abs(a[i] - b[i]), 1e-4F * (1.0F + glm::abs(b[i])))))
            return false;
    return true;
}

// Position of a view's point in the previous frame, from its motion. now, then: of the two views.
glm::vec3 earlier(const GBuffer& view, const PixelPositions& now, const PixelPositions& then,
                  std::size_t pixel) {
    const double depth = view.depth[pixel];
    if (!is_surface(view.depth[pixel])) return glm::vec3(0);
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

backend::Extent guard_border(backend::Extent frame, double guard) {
    const auto pixels = [&](double side) {
        return static_cast<std::uint32_t>(std::floor(guard * side + 0.5));
    };
    return {pixels(frame.width), pixels(frame.height)};
}

backend::Extent with_border(backend::Extent frame, const Border& border) {
    return {border.left + frame.width + border.right, border.top + frame.height + border.bottom};
}

backend::Extent frame_of(const GBuffer& view) {
    const auto inner = [](std::uint32_t side, std::uint32_t before, std::uint32_t after) {
        if (before < side && after < side - before) return side - before - after;
        throw std::invalid_argument(fmt::format(
            "guard band of {} and {} pixels: a view of {} has no frame left", before, after, side));
    };
    const Border& border = view.border;
    return {inner(view.extent.width, border.left, border.right),
            inner(view.extent.height, border.top, border.bottom)};
}

Camera with_border(const Camera& camera, backend::Extent frame, backend::Extent border) {
    if (border == backend::Extent{}) return camera;
    Camera wider = camera;
    const double factor = (frame.height + 2.0 * border.height) / frame.height;  // 1 + 2 guard
    wider.fovy_rad = 2.0 * std::atan(factor * std::tan(0.5 * camera.fovy_rad));
    wider.view_height = factor * camera.view_height;
    return wider;
}

GBuffer cropped(const GBuffer& view) {
    if (view.border == Border{}) return view;
    const Border& band = view.border;
    GBuffer inner = in_window(view, -glm::ivec4(band.left, band.top, band.right, band.bottom));
    inner.stored.reset();
    const PixelPositions positions(inner);
    for (std::size_t i = 0; i < inner.motion.size(); ++i)  // none from within the band is valid
        if (!positions.contains(glm::vec2(positions.center(i)) - glm::vec2(inner.motion[i])))
            inner.motion[i].z = 0.0F;
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
    return in_window(std::move(view), {lack.left, lack.top, lack.right, lack.bottom});
}

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
