// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "experiment/experiment.hpp"
#include "experiment/runner.hpp"
#include "scene/analytic_scene.hpp"

namespace gloam::experiment {

// All that the layers say of one candidate in one case.
struct Subject {
    Kind kind = Kind::effect;
    effect::Settings settings;  // for a radius of 1
    bool sequence = true;
    bool hoisted = true;
    double radius = 1.0;  // in units of the scene's
    bool enough_samples = false;
    std::vector<std::string> pictures;
    PlainLoop plain;
};

// Of the experiment's, the case's and the candidate's layer. Throws std::invalid_argument for settings that
// do not exist, with the names of the case and the candidate.
[[nodiscard]] Subject subject_of(const Experiment& experiment, const Case& one, const Candidate& candidate,
                                 const Place& place);

// The view of a case in closed form. Throws std::invalid_argument that lists the names.
[[nodiscard]] scene::ClosedFormView closed_form_of(const Case& one);

// The frames of a case at a size of the experiment.
[[nodiscard]] BenchmarkFrames frames_of(const Experiment& experiment, const Case& one,
                                        backend::Extent extent);

[[nodiscard]] bool takes_part(const Case& one, const Candidate& candidate);

}  // namespace gloam::experiment
