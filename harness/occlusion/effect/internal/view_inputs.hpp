// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/internal/executor.hpp"
#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"

// What frames need of a view, and how they get it. The functions named require... throw
// std::invalid_argument that names the setting or the image.
namespace gloam::effect {

// The guard band that the settings ask for.
void require_guard(const scene::GBuffer& view, const Settings& settings);

// At least as many depth layers as the settings ask for.
void require_layers(const scene::GBuffer& view, const Settings& settings);

// Images of this size: depth and its layers, normals, positions in the previous frame.
void require_sizes(const scene::GBuffer& view, gpu::Extent extent);

// Uploads a view to the images depth, normal, previous_position and layers, those that it has. Missing images
// are made. stores: depth and normals as the engine stores them, if it does; otherwise linear depth and
// normals of view space. extent: of the view. prefix: of the names.
void upload(const scene::GBuffer& view, gpu::Extent extent, bool stores, Resources& resources,
            const std::string& prefix = "");

// Uploads linear depth and normals of view space. Missing normals are reconstructed from depth.
void take_linear(const scene::GBuffer& view, Resources& resources, Executor& executor,
                 const PassWatcher& watcher, const std::string& prefix = "");

}  // namespace gloam::effect
