// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "effect/metrics.hpp"
#include "effect/pixel_classes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::cli {

// The relation of a view to the previous one.
enum class ViewLink {
    same,     // the same view again
    follows,  // the next of a sequence
    cut       // an unrelated view
};

// Follows the frames of one call of `gloam render`: the change of the picture from frame to frame, and the
// pixels that a temporal method treats differently.
class RenderHistory {
  public:
    // Takes the next frame. Views without normals have no relation to earlier ones.
    void advance(const scene::GBuffer& view, ViewLink link, double radius, const std::vector<float>& image);

    // Mean change at the same surface points since the frame before; nullopt in the first.
    [[nodiscard]] const std::optional<double>& flicker() const { return flicker_; }

    // The classes of the last frame's pixels; nullopt if there was no frame before it.
    [[nodiscard]] const std::optional<effect::PixelClasses>& classes() const { return classes_; }

  private:
    std::optional<scene::GBuffer> view_;
    std::vector<float> image_;
    std::optional<double> flicker_;
    std::optional<effect::PixelClasses> classes_;
};

}  // namespace gloam::cli
