// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/occlusion/render_input.hpp"
#include "cli/occlusion/render_pictures.hpp"
#include "pictures/light.hpp"
#include "report/output.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// The name of a run among several: its preset, of a file without folder and suffix, where presets are
// compared, else its method. Throws like settings_for().
[[nodiscard]] std::string name_of(const RenderOptions& options);

// The common parts of runs of several methods on one input: the device, the passes, and the light of the last
// rendered view, which does not depend on the method.
class RenderBench {
  public:
    // Opens the device that the options name.
    explicit RenderBench(const RenderOptions& options);

    // The light of the view with this number.
    [[nodiscard]] const pictures::PictureLight& light_of(const RenderInput& input, int number,
                                                         const scene::GBuffer& view, bool watched);

    // Call it before a view of another input.
    void forget_light() { lit_.reset(); }

    gpu::Device device;
    scene::PassLibrary passes;
    effect::Composite composite;

  private:
    std::optional<int> lit_;
    pictures::PictureLight light_;
};

// The output of a run: written to `folder`, with names that begin with `prefix`.
struct RenderOutput {
    report::OutputFolder* folder = nullptr;  // null: nothing is written
    std::string prefix = {};
};

// Renders the views of an input with one method and writes their files, PREFIXrender.json among them.
[[nodiscard]] Rendered render(const RenderOptions& options, const RenderInput& input, RenderBench& bench,
                              const RenderOutput& output);

}  // namespace gloam::cli
