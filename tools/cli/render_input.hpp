// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/render.hpp"
#include "effect/errors.hpp"
#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {

// The views to shade: one still view, on which frames accumulate, or a sequence of views.
struct RenderInput {
    std::string name;
    std::vector<int> views;  // their numbers, which are also in the names of written files
    int first_frame = 0;     // of a scene: view 0 shows it
    int frames_per_view = 1;
    std::function<scene::GBuffer(const gpu::Device&, const scene::PassLibrary&, int view)> load;
    std::shared_ptr<const scene::Scene> scene;  // null for G-buffers from elsewhere
    effect::TrueOcclusion truth;                // empty if it is unknown
    std::string truth_name;
};

// Checks the names and files of the options, as far as that is possible without a device. Throws
// std::invalid_argument or std::runtime_error with the error in one line. `like`: an input of the same
// source, whose scene is used instead of reading it again; null: none.
[[nodiscard]] RenderInput open_input(const RenderOptions& options, const RenderInput* like = nullptr);

}  // namespace gloam::cli
