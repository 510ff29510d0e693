// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/pipelines.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/view_images.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The passes that make depth and normals of a view what all other passes read: conversion of what an engine
// stores, and normals from depth where there are none. They run once for each view.
class SurfaceInputs {
  public:
    void take(const scene::GBuffer& gbuffer, const View& view);

    // Appends the passes. nothing: an image for bindings that are not
    // read.
    void append_steps(Pipelines& pipelines, const ViewImages& images, const gpu::Image& nothing,
                      std::vector<Step>& steps) const;

  private:
    bool converts_ = false;
    bool reconstructs_ = false;
    InputProgram program_;
    InputParameters input_constants_{};
    NormalParameters normal_constants_{};
};

}  // namespace gloam::effect
