// SPDX-License-Identifier: MIT
#pragma once

#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"

// What settings need of a view. Each throws std::invalid_argument that names the setting.
namespace gloam::effect {

// The guard band that the settings ask for.
void require_guard(const scene::GBuffer& view, const Settings& settings);

// At least as many depth layers as the settings ask for.
void require_layers(const scene::GBuffer& view, const Settings& settings);

}  // namespace gloam::effect
