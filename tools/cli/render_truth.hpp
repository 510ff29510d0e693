// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "cli/render.hpp"
#include "cli/render_input.hpp"
#include "effect/errors.hpp"
#include "report/output_folder.hpp"
#include "scene/pfm.hpp"
#include "scene/truth_cache.hpp"

namespace gloam::cli {

// The traced truth of one view.
struct TracedView {
    std::optional<scene::TracedTruth> geometry;  // (G); not for a G-buffer from elsewhere
    scene::TracedTruth depth;                    // (D)
};

// The truth for a view.
struct ViewTruth {
    effect::Truth truth;               // empty: unknown
    std::optional<TracedView> traced;  // with --truth
};

// The source of the truth in a call of `gloam render`: rays, a file, or a closed form.
class TruthSource {
  public:
    // Reads the file of the options. Throws std::runtime_error with its name, std::invalid_argument for
    // options that exclude each other.
    TruthSource(const RenderOptions& options, const RenderInput& input);

    [[nodiscard]] std::string name() const;  // empty: there is none

    // Whether every view of a sequence is compared, or only the last: tracing takes long, and a file has one
    // image.
    [[nodiscard]] bool every_view() const;

    // frame: of the scene.
    [[nodiscard]] ViewTruth of(const scene::GBuffer& view, int frame, double radius) const;

  private:
    [[nodiscard]] TracedView traced(const scene::GBuffer& view, int frame, double radius) const;

    const RenderOptions& options_;
    const RenderInput& input_;
    std::optional<scene::FloatImage> reference_;
    scene::Falloff falloff_ = scene::Falloff::linear;
};

// Writes the traced images: PREFIXtruth.pfm and .png, PREFIXtruth_depth.pfm and .png, PREFIXtruth_error.pfm
// (the standard errors).
void write_truth(report::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const TracedView& traced);

}  // namespace gloam::cli
