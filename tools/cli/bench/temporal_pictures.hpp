// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/temporal_report.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// Curves of error (SVG), and the last frame's images (PNG): occlusion, error, convergence, samples kept;
// their names begin with the scene's. Throws std::runtime_error when gnuplot is missing.
void write_pictures(report::OutputFolder& folder, const TemporalReport& report);

}  // namespace gloam::cli
