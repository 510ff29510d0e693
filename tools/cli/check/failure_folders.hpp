// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "cli/check/hand_over.hpp"
#include "report/check_report.hpp"
#include "report/failure_text.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// A folder with a subfolder for each failure: DEVICE/EQUATION-VARIANT/{report.txt, shader.comp,
// shader.spvasm, shader.spv, repro.amber}. The constructor finds out whether it can be written to, before the
// work. Without a failure nothing remains.
class FailureFolders {
  public:
    // An empty path: no folder. Throws std::runtime_error with the path that cannot be written.
    explicit FailureFolders(std::filesystem::path folder);

    [[nodiscard]] bool wanted() const { return folder_.has_value(); }

    // Writes a failure and returns its folder. report.txt states which parts are missing and why (see
    // HandOver::error).
    std::filesystem::path write(const report::DeviceSummary& device, const check::Answer& row,
                                const HandOver& hand_over, const report::RunAgain& again);

  private:
    std::optional<report::OutputFolder> folder_;
};

}  // namespace gloam::cli
