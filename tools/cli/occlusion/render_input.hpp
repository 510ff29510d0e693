// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/image_files.hpp"
#include "cli/occlusion/render.hpp"
#include "effect/errors.hpp"
#include "report/output.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"
#include "scene/truth.hpp"

namespace gloam::cli {

// The views to shade: one still view, on which frames accumulate, or a sequence of views.
struct RenderInput {
    std::string name;
    std::vector<int> views;  // their numbers, which are also in the names of written files
    int first_frame = 0;     // of a scene: view 0 shows it
    int frames_per_view = 1;
    int picture_samples = 1;  // on each side of a pixel, of lit pictures
    std::function<scene::GBuffer(const gpu::Device&, int view)> load;
    std::shared_ptr<const scene::Scene> scene;  // null for G-buffers from elsewhere
    effect::TrueOcclusion truth;                // empty if it is unknown
    std::string truth_name;
};

// Checks the names and files of the options, as far as that is possible without a device. Throws
// std::invalid_argument or std::runtime_error with the error in one line. `like`: an input of the same
// source, whose scene is used instead of reading it again; null: none.
[[nodiscard]] RenderInput open_input(const RenderOptions& options, const RenderInput* like = nullptr);

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
    std::optional<base::FloatImage> reference_;
    scene::Falloff falloff_ = scene::Falloff::linear;
};

// Writes the traced images: PREFIXtruth.pfm and .png, PREFIXtruth_depth.pfm and .png, PREFIXtruth_error.pfm
// (the standard errors).
void write_truth(report::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const TracedView& traced);

}  // namespace gloam::cli
