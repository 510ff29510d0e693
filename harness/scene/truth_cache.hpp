// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "scene/truth.hpp"

namespace gloam::scene {

// A folder of traced truth, keyed by a hash of everything that the truth depends on: triangles as the frame's
// camera sees them, depth, normals, projection, settings. A damaged or truncated file counts as missing. A
// file that cannot be written is ignored.
class TruthCache {
  public:
    // folder: created if it is missing; empty: no cache.
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Like trace_geometry() and trace_depth(), from the cache if possible. They throw like those.
    [[nodiscard]] TracedTruth geometry(const Scene& scene, int frame, const GBuffer& view,
                                       const TruthSettings& settings) const;
    [[nodiscard]] TracedTruth depth(const GBuffer& view, const TruthSettings& settings) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace gloam::scene
