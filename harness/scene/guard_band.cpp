// SPDX-License-Identifier: MIT
#include "scene/guard_band.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace gloam::scene {
namespace {

std::uint32_t pixels_of(double guard, std::uint32_t side) {
    return static_cast<std::uint32_t>(std::floor(guard * side + 0.5));
}

// The factor (1 + 2 guard) along one axis.
double widening(std::uint32_t side, std::uint32_t border) {
    return (side + 2.0 * border) / side;
}

// Motion from within the band is invalid for the frame.
void keep_motion_inside(GBuffer& frame) {
    const glm::vec2 size(frame.extent.width, frame.extent.height);
    for (std::size_t i = 0; i < frame.motion.size(); ++i) {
        const glm::vec2 now(static_cast<float>(i % frame.extent.width) + 0.5F,
                            static_cast<float>(i / frame.extent.width) + 0.5F);
        const glm::vec2 then = now - glm::vec2(frame.motion[i]);
        const bool inside = then.x >= 0.0F && then.y >= 0.0F && then.x < size.x && then.y < size.y;
        if (!inside) frame.motion[i].z = 0.0F;
    }
}

}  // namespace

gpu::Extent guard_border(gpu::Extent frame, double guard) {
    if (!(guard >= 0.0 && guard <= 0.5))
        throw std::invalid_argument(fmt::format("guard {:g}: expected 0 to 0.5", guard));
    return {pixels_of(guard, frame.width), pixels_of(guard, frame.height)};
}

gpu::Extent with_border(gpu::Extent frame, gpu::Extent border) {
    return {frame.width + 2 * border.width, frame.height + 2 * border.height};
}

gpu::Extent frame_of(const GBuffer& view) {
    const auto inner = [](std::uint32_t side, std::uint32_t border) {
        if (border < side && 2 * border < side) return side - 2 * border;
        throw std::invalid_argument(fmt::format(
            "guard band of {} pixels on each side: a view of {} has no frame left", border, side));
    };
    return {inner(view.extent.width, view.border.width), inner(view.extent.height, view.border.height)};
}

Camera with_border(const Camera& camera, gpu::Extent frame, gpu::Extent border) {
    if (border == gpu::Extent{}) return camera;
    Camera wider = camera;
    const double factor = widening(frame.height, border.height);
    wider.fovy_rad = 2.0 * std::atan(factor * std::tan(0.5 * camera.fovy_rad));
    wider.view_height = factor * camera.view_height;
    return wider;
}

GBuffer cropped(const GBuffer& view) {
    if (view.border == gpu::Extent{}) return view;
    const gpu::Extent frame = frame_of(view);
    GBuffer inner{.extent = frame,
                  .depth = cropped(view, view.depth),
                  .normal = cropped(view, view.normal),
                  .motion = cropped(view, view.motion),
                  .previous_depth = cropped(view, view.previous_depth),
                  .color = cropped(view, view.color),
                  .camera = view.camera,
                  .ao_radius = view.ao_radius,
                  .previous_position = cropped(view, view.previous_position),
                  .object = cropped(view, view.object),
                  .triangle = cropped(view, view.triangle)};
    for (const std::vector<float>& layer : view.layers) inner.layers.push_back(cropped(view, layer));
    glm::mat4& projection = inner.camera.proj_vk;
    const auto narrowed = [](float scale, std::uint32_t side, std::uint32_t border) {
        return static_cast<float>(double{scale} * widening(side, border));
    };
    projection[0][0] = narrowed(projection[0][0], frame.width, view.border.width);
    projection[1][1] = narrowed(projection[1][1], frame.height, view.border.height);
    keep_motion_inside(inner);
    return inner;
}

}  // namespace gloam::scene
