// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/results.hpp"
#include "scene/pass_library.hpp"

namespace gloam::experiment {

// A picture that a candidate asks for.
struct Picture {
    std::string name;  // "CASE-CANDIDATE-KIND"
    std::string kind;  // one of Layer::pictures
    backend::Extent extent;
    std::vector<float> values;  // occlusion, magnitudes of errors, or parts of the most that there can be
};

// Where an experiment runs. The device and the passes must outlive the call.
struct Place {
    const backend::vulkan::Device& device;
    const scene::PassLibrary& passes;
    std::filesystem::path truth_cache;  // empty: the truth is not kept
    std::filesystem::path meshes;       // of views
    std::function<effect::Settings(const std::string& preset)> preset_of;
    // Makes a function that is called with the part done, in [0, 1]; `what` is being done.
    std::function<std::function<void(double)>(const std::string& what)> progress;
    std::function<void(const std::string& line)> keep{};  // is given the line of each visit
    std::function<void(const Picture&)> show{};           // is given each picture
};

// Throws std::invalid_argument, before any work, for a scene, preset, method or setting that does not exist,
// more scored frames than there are, and an experiment without a candidate.
void require_possible(const Experiment& experiment, const Place& place);

// Measures every candidate of every case at every size, in rounds, but for the visits that the record has,
// and adds them to it. Round 0 gives the errors and compiles, the others give times. Every other round visits
// the candidates in reverse, so that the machine's drift affects all alike. Requires what require_possible()
// does. Throws like BenchmarkViews and effect::AmbientOcclusion, and std::runtime_error for a device without
// timestamps if there are rounds.
void run(const Experiment& experiment, const std::vector<backend::Extent>& sizes, const Place& place,
         Record& record);

}  // namespace gloam::experiment
