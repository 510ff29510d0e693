// SPDX-License-Identifier: MIT
#include "effect/internal/require_view.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "scene/guard_band.hpp"

namespace gloam::effect {

void require_guard(const scene::GBuffer& view, const Settings& settings) {
    const gpu::Extent none;
    const double guard = double{settings.guard};
    if (view.border != none || scene::guard_border(view.extent, guard) == none) return;
    throw std::invalid_argument(fmt::format("guard {:g}: the view has no guard band", guard));
}

void require_layers(const scene::GBuffer& view, const Settings& settings) {
    if (view.layers.size() + 1 >= settings.layers) return;
    throw std::invalid_argument(fmt::format("layers {}: the view has {}, the first among them",
                                            settings.layers, view.layers.size() + 1));
}

}  // namespace gloam::effect
