// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiment/configuration_study.hpp"
#include "experiment/experiment.hpp"
#include "gpu/device.hpp"
#include "scene/pass_library.hpp"
#include "scene/truth.hpp"

namespace gloam::experiment {

// What a candidate reached in a case.
struct Cell {
    std::optional<FrameQuality> quality;            // nullopt: without a truth
    std::vector<std::vector<FrameReading>> rounds;  // the readings of each timed round
    std::optional<double>
        difference;     // RMS of the displayed image of the last frame and the first candidate's
    effect::Work work;  // of the last frame
    std::optional<double> own_radius_error;  // the error against the truth for the scene's own radius
    std::uint32_t samples_asked = 0;
};

struct CaseResult {
    Case shown;
    std::vector<std::optional<Cell>> cells;  // of the experiment's candidates; nullopt: not measured
};

struct SizeResult {
    gpu::Extent extent;
    std::vector<CaseResult> cases;
};

// Where an experiment runs. The device and the passes must outlive the call.
struct Place {
    const gpu::Device& device;
    const scene::PassLibrary& passes;
    std::filesystem::path truth_cache;  // empty: the truth is not kept
    std::filesystem::path meshes;       // of views
    std::function<effect::Settings(const std::string& preset)> preset_of;
    // Makes a function that is called with the part done, in [0, 1]; `what` is being done.
    std::function<std::function<void(double)>(const std::string& what)> progress;
};

// Whether a table shows the quantity.
[[nodiscard]] bool shows(const Experiment& experiment, std::string_view quantity);

// Throws std::invalid_argument, before any work, for a scene, preset, method or setting that does not exist,
// more scored frames than there are, and an experiment without a candidate.
void require_possible(const Experiment& experiment, const Place& place);

// Measures every candidate of every case at every size, in rounds: round 0 gives the errors and compiles, the
// others give times. Every other round visits the candidates in reverse, so that the machine's drift affects
// all alike. Throws like require_possible(), BenchmarkViews and effect::AmbientOcclusion, and
// std::runtime_error for a device without timestamps if there are rounds.
[[nodiscard]] std::vector<SizeResult> run(const Experiment& experiment, const std::vector<gpu::Extent>& sizes,
                                          const Place& place);

}  // namespace gloam::experiment
