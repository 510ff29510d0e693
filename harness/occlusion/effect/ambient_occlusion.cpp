// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

struct AmbientOcclusion::Impl {
    std::unique_ptr<FramePasses> study;
    std::unique_ptr<FramePasses> frame;
    Settings settings;            // of the last view
    std::vector<TileWork> tiles;  // of it, before the frame marks any
    PassWatcher watcher;          // empty: no watcher

    [[nodiscard]] FramePasses& passes(const Settings& chosen) const {
        return chosen.passes == Passes::frame ? *frame : *study;
    }
    void take(const scene::GBuffer& view, const Settings& chosen, bool follows) {
        require_guard(view, chosen);
        (void)scene::frame_of(view);
        passes(chosen).take(view, chosen, follows);
        settings = chosen;
        tiles = tile_work_of(view, chosen);
    }
};

void crop(const scene::GBuffer& shape, Frame& frame) {
    frame.extent = scene::frame_of(shape);
    for (std::vector<float>* image : {&frame.occlusion, &frame.filtered, &frame.convergence, &frame.kept})
        if (!image->empty()) *image = scene::cropped(shape, *image);
    if (!frame.bent.empty()) frame.bent = scene::cropped(shape, frame.bent);
}

AmbientOcclusion::AmbientOcclusion(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(study_passes(device, passes), frame_passes(device, passes))) {}

void AmbientOcclusion::begin(const scene::GBuffer& view, const Settings& settings) {
    validate(settings);
    impl_->take(view, settings, false);
}

void AmbientOcclusion::advance(const scene::GBuffer& view) {
    impl_->take(view, impl_->settings, true);
}

void AmbientOcclusion::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

Frame AmbientOcclusion::next(int repeat) {
    const Impl& impl = *impl_;
    Frame frame = impl.passes(impl.settings).next(repeat, impl.watcher);
    const std::vector<TileWork> marked = std::exchange(frame.tiles, impl.tiles);
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (frame.tiles[i] == TileWork::half) frame.tiles[i] = marked[i];
    return frame;
}

}  // namespace gloam::effect
