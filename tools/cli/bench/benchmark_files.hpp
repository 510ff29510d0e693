// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "cli/bench/benchmark_options.hpp"
#include "report/benchmark/result.hpp"
#include "report/output_file.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// Reads a result file. Throws std::runtime_error with its name and the part that `gloam bench --json` would
// not have written.
[[nodiscard]] report::Benchmark benchmark_from(const std::filesystem::path& file);

// The requested output files. The constructor finds out whether they can be written, before the work.
class BenchmarkFiles {
  public:
    // Throws std::runtime_error for a file that cannot be written.
    explicit BenchmarkFiles(const BenchmarkOptions& options);

    // Keeps the folder of --out even if the run fails, because of its journal.
    void keep_folder();

    // Writes all files: --json, --csv, --report with its plots in images/benchmark beside it, and in --out
    // results.json, results.csv and every plot as SVG and PNG. Throws std::runtime_error for a file that
    // cannot be written, and if gnuplot is missing.
    void write(const report::Benchmark& benchmark);

  private:
    report::OutputFile json_;
    report::OutputFile csv_;
    report::OutputFile page_;
    std::optional<report::OutputFolder> out_;
    std::optional<report::OutputFolder> images_;
};

}  // namespace gloam::cli
