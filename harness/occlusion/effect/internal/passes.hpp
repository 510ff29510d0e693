// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"

// The shaders of the passes.
namespace gloam::effect {

// A size and a choice as shaders take them.
[[nodiscard]] inline glm::ivec2 vector_of_size(backend::Extent extent) {
    return {static_cast<int>(extent.width), static_cast<int>(extent.height)};
}
[[nodiscard]] inline std::uint32_t flag(bool value) {
    return value ? 1U : 0U;
}

// The part of a view that is the same in all of its frames.
struct View {
    scene::CameraFrame camera;
    backend::Extent extent;  // with the border
    scene::Border border;
};

// One frame: the settings, the view, and everything else that decides what the frame runs.
struct Moment {
    Settings settings;
    View view;                               // the engine's
    View before;                             // of the frame before; the same one where there is none
    std::optional<Preparation> preparation;  // of the method
    // How the engine stores depth and normals. None: as passes read them.
    std::optional<scene::Encoding> converted;
    bool has_normals = true;        // the engine gives normals; otherwise they are reconstructed
    bool has_positions = false;     // the engine gives previous positions of surface points
    bool new_view = true;           // the view was not that of the frame before
    bool moved = true;              // the history, if there is one, belongs to another view
    bool shows_unfiltered = false;  // the unfiltered occlusion is remapped, too
    std::uint32_t step = 0;         // of a pass that runs several times

    // Sets the view and the one before it, and what depends on their size.
    void look(const View& now, const View& last);

    // Whether the history is moved to the view.
    [[nodiscard]] bool moves_history() const { return moved && settings.history; }
};

// The shaders, with their definitions.
[[nodiscard]] PassSource occlusion_source(const Moment& moment);
// settings: with a filter.
[[nodiscard]] PassSource filter_source(const Settings& settings);
// from_history: it reads the history; otherwise an image of one channel.
[[nodiscard]] PassSource remap_source(const Settings& settings, bool from_history);
// file: in glsl/passes/study/preparation.
[[nodiscard]] PassSource preparation_source(const Moment& moment, const std::string& file);

// The format of the image that the last pass writes, and the macro for another than r32f.
[[nodiscard]] backend::vulkan::Format format_of(OutputFormat output);
void define_output(OutputFormat output, std::vector<std::string>& defines);

// Groups of 8 x 8 invocations that cover an image.
[[nodiscard]] std::array<std::uint32_t, 3> groups_for(backend::Extent extent);

}  // namespace gloam::effect
