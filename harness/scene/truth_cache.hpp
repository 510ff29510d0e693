// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "scene/truth.hpp"

namespace gloam::scene {

// Traced truth that is kept in a folder, under a hash of everything it depends on: triangles as the frame's
// camera sees them, depth, normals, projection, settings. A file that is damaged or cut short counts as
// missing; one that cannot be written is done without.
class TruthCache {
  public:
    // folder: made where it is missing; empty: nothing is kept.
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // As trace_geometry() and trace_depth(). Throw like them.
    [[nodiscard]] TracedTruth geometry(const Scene& scene, int frame, const GBuffer& view,
                                       const TruthSettings& settings) const;
    [[nodiscard]] TracedTruth depth(const GBuffer& view, const TruthSettings& settings) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace gloam::scene
