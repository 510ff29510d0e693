// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "cli/bench/benchmark_options.hpp"
#include "report/benchmark/result.hpp"
#include "report/output_file.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

// A result file. Throws std::runtime_error that names it and what in it is not as `gloam bench --json` writes
// it.
[[nodiscard]] report::Benchmark benchmark_from(const std::filesystem::path& file);

// The files that a run was asked for. Whether they can be written is found out before the work.
class BenchmarkFiles {
  public:
    // Throws std::runtime_error for what cannot be written.
    explicit BenchmarkFiles(const BenchmarkOptions& options);

    // The folder of --out stays from now on, whatever becomes of the run: its journal is worth it.
    void keep_folder();

    // Everything: --json, --csv, --report with its plots in images/benchmark beside it, and in --out
    // results.json, results.csv and every plot as SVG and PNG. Throws std::runtime_error for what cannot be
    // written, and where gnuplot is missing.
    void write(const report::Benchmark& benchmark);

  private:
    report::OutputFile json_;
    report::OutputFile csv_;
    report::OutputFile page_;
    std::optional<report::OutputFolder> out_;
    std::optional<report::OutputFolder> images_;
};

}  // namespace gloam::cli
