// SPDX-License-Identifier: MIT
#include "effect/study/sequence.hpp"

#include <utility>

namespace gloam::effect {

std::vector<SequenceFrame> sequence_of(const gpu::Device& device, const scene::PassLibrary& passes,
                                       const scene::Scene& scene, gpu::Extent extent, int frames) {
    std::vector<SequenceFrame> sequence;
    PixelClasses classes({.radius = scene.ao_radius});
    for (int i = 0; i < frames; ++i) {
        scene::GBuffer view = scene::rasterize(device, passes, scene, extent, {.frame = i, .motion = true});
        std::optional<HistoryMap> history;
        if (i > 0) history.emplace(view, sequence.back().view);
        classes.advance(view, history);
        scene::GBuffer wide = scene::rasterize(device, passes, scene, extent,
                                               {.frame = i, .motion = true, .guard = study_guard});
        sequence.push_back({std::move(view), std::move(wide), std::move(history), classes});
    }
    return sequence;
}

scene::GBuffer standing_still(scene::GBuffer view) {
    view.motion.clear();
    view.previous_position.clear();
    view.camera.previous_view.reset();
    view.camera.previous_from_current.reset();
    return view;
}

}  // namespace gloam::effect
