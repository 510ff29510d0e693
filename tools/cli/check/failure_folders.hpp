// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "cli/check/hand_over.hpp"
#include "report/check_report.hpp"
#include "report/failure_text.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// A folder with one folder for each failure: DEVICE/EQUATION-VARIANT/{report.txt, shader.comp, shader.spvasm,
// shader.spv, repro.amber}. Whether it can be written to is found out before the work; without a failure
// nothing of it stays.
class FailureFolders {
  public:
    // An empty path keeps nothing. Throws std::runtime_error that names what cannot be written.
    explicit FailureFolders(std::filesystem::path folder);

    [[nodiscard]] bool wanted() const { return folder_.has_value(); }

    // Returns the folder that was written; what cannot be had (see HandOver::error) is said in report.txt.
    std::filesystem::path write(const report::DeviceSummary& device, const check::Answer& row,
                                const HandOver& hand_over, const report::RunAgain& again);

  private:
    std::optional<report::OutputFolder> folder_;
};

}  // namespace gloam::cli
