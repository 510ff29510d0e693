// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/scene.hpp"

namespace gloam::pictures {

// Light that leaves the surfaces of a view towards the eye, split as in an engine: ambient light, which
// ambient occlusion darkens, and the direct light of one lamp, which it does not. Linear, 1 is white.
struct SplitLight {
    std::vector<glm::vec3> ambient;  // of an unoccluded sky; 0 at the background
    std::vector<glm::vec3> direct;   // of the sun or lamp, shadows traced; the sky at the background
};

struct LightingOptions {
    int frame = 0;                           // of the scene
    int rays = 16;                           // towards the sun or lamp: its disc causes soft shadows
    std::function<void(double)> progress{};  // called with the completed part, in [0, 1]
};

// The light of a picture at several samples of each pixel, so that its edges are smooth. The occlusion stays
// that of the pixels: a sample shows the pixel of `pixel`.
struct PictureLight {
    backend::Extent extent;            // in pixels of the view
    int samples = 1;                   // on each side of a pixel
    SplitLight light;                  // of each sample: extent * samples on each side, rows from the top
    std::vector<glm::vec3> albedo;     // of each sample; 0 at the background
    std::vector<std::uint32_t> pixel;  // of each sample: the pixel whose surface it shows

    [[nodiscard]] backend::Extent sampled() const {
        const auto count = static_cast<std::uint32_t>(samples);
        return {extent.width * count, extent.height * count};
    }

    // A value for each sample, from those of the pixels.
    [[nodiscard]] std::vector<float> spread(const std::vector<float>& of_pixels) const;

    // The mean of each pixel's samples.
    [[nodiscard]] std::vector<glm::vec3> mean(const std::vector<glm::vec3>& of_samples) const;
};

// The light of a view without its guard band, at the samples of `fine`: the same view with `samples` times as
// many pixels on each side. A sample shows its own pixel, unless it is off the plane of that pixel's surface
// by more than 0.6 % of its depth; then that of the 3 x 3 pixels around it whose plane is nearest. Surfaces
// are diffuse, with GBuffer::color, or default_color. `scene`: the scene that casts shadows, in the frame
// that the view shows; nullptr: no shadows, light of the sun. Missing normals are reconstructed from depth.
// Bit-identical for any number of threads.
[[nodiscard]] PictureLight picture_light(const scene::GBuffer& view, const scene::GBuffer& fine, int samples,
                                         const scene::Scene* scene, const LightingOptions& options = {});

}  // namespace gloam::pictures
