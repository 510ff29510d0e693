// SPDX-License-Identifier: MIT
#include "cli/render_history.hpp"

namespace gloam::cli {
namespace {

// A view that does not move.
scene::GBuffer standing_still(scene::GBuffer view) {
    view.motion.clear();
    view.previous_position.clear();
    view.camera.previous_view.reset();
    view.camera.previous_from_current.reset();
    return view;
}

}  // namespace

void RenderHistory::advance(const scene::GBuffer& view, ViewLink link, double radius,
                            const std::vector<float>& image) {
    flicker_.reset();
    if (view.normal.empty()) {
        view_.reset();
        classes_.reset();
        return;
    }
    const bool follows = view_ && link != ViewLink::cut;
    if (!follows) classes_.emplace(effect::PixelClasses::Settings{.radius = radius});
    std::optional<effect::HistoryMap> history;
    if (follows) history.emplace(link == ViewLink::same ? standing_still(view) : view, *view_);
    if (history) flicker_ = effect::mean_change(*history, image, image_);
    classes_->advance(view, history);
    view_ = view;
    image_ = image;
}

}  // namespace gloam::cli
