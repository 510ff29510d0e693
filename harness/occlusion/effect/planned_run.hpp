// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "effect/plan.hpp"
#include "pass/pass.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The images of a plan by name, each with its levels, and its buffers.
struct PlanMemory {
    // The engine's depth and normals are those of the view; everything else is 0, or as the plan has it.
    PlanMemory(const Plan& plan, const scene::GBuffer& view);

    [[nodiscard]] const subject::Image& image(const std::string& name) const {
        return images.at(name).front();
    }

    std::map<std::string, std::vector<subject::Image>> images;
    std::map<std::string, std::vector<subject::Word>> buffers;
};

// Runs the passes of a plan one after another on the device of a lab: Vulkan and the interpreter get their
// modules, OpenGL the texts that engines take. Throws like pass::Pass; backend::Unsupported for a pass that
// is no text of OpenGL ES.
void run(const subject::Lab& lab, const Plan& plan, const scene::PassLibrary& passes, PlanMemory& memory);

}  // namespace gloam::effect
