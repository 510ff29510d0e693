// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "effect/metrics.hpp"
#include "effect/pixel_classes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::cli {

// How a view goes with the one before it.
enum class ViewLink {
    same,     // the same view again
    follows,  // the next of a sequence
    cut       // another
};

// Follows the frames of one call of `gloam render`: how much the picture changes from frame to frame, and
// which pixels a temporal method treats differently.
class RenderHistory {
  public:
    // The next frame. Views without normals have nothing to do with those before.
    void advance(const scene::GBuffer& view, ViewLink link, double radius, const std::vector<float>& image);

    // Mean change at the same surface points since the frame before; nullopt in the first.
    [[nodiscard]] const std::optional<double>& flicker() const { return flicker_; }

    // The classes of the pixels of the last frame; nullopt where there was none before it.
    [[nodiscard]] const std::optional<effect::PixelClasses>& classes() const { return classes_; }

  private:
    std::optional<scene::GBuffer> view_;
    std::vector<float> image_;
    std::optional<double> flicker_;
    std::optional<effect::PixelClasses> classes_;
};

}  // namespace gloam::cli
