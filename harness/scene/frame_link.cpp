// SPDX-License-Identifier: MIT
#include "scene/frame_link.hpp"

#include <cmath>

#include "scene/pixel_positions.hpp"

namespace gloam::scene {
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

bool inside(const glm::dvec2& place, gpu::Extent extent) {
    return place.x >= 0.0 && place.y >= 0.0 && place.x < extent.width && place.y < extent.height;
}

// Positions of a view's points in the previous frame, from its motion.
class Earlier {
  public:
    Earlier(const GBuffer& view, const GBuffer& previous)
        : view_(view), now_(view), then_(previous), change_(*view.camera.previous_from_current) {}

    [[nodiscard]] glm::vec3 of(std::size_t pixel) const {
        const double depth = view_.depth[pixel];
        if (!(depth > 0.0 && std::isfinite(depth))) return glm::vec3(0);
        const glm::dvec3 if_still(change_ * glm::dvec4(now_.at(pixel, depth), 1.0));
        const double before =
            view_.previous_depth.empty() ? -if_still.z : double{view_.previous_depth[pixel]};
        if (!std::isfinite(before) || (!(before > 0.0) && !then_.orthographic())) return glm::vec3(0);
        const glm::vec3& motion = view_.motion[pixel];
        const glm::vec3 moved = then_.at(pixel, before, -glm::dvec2(motion));
        if (motion.z > 0.5F) return moved;
        // Invalid motion: the point was outside the previous image, or its position is unknown.
        if (!inside(then_.pixel_of(moved), view_.extent)) return moved;
        const bool left = if_still.z < 0.0 && !inside(then_.pixel_of(if_still), view_.extent);
        return left ? glm::vec3(if_still) : glm::vec3(0);
    }

  private:
    const GBuffer& view_;
    PixelPositions now_;
    PixelPositions then_;
    glm::dmat4 change_;
};

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
    const Earlier earlier(view, previous);
    view.previous_position.reserve(view.depth.size());
    for (std::size_t i = 0; i < view.depth.size(); ++i) view.previous_position.push_back(earlier.of(i));
}

}  // namespace gloam::scene
