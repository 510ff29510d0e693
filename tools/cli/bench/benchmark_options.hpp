// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// The options of `gloam bench`.
struct BenchmarkOptions {
    std::vector<std::string> scenes{"columns", "corner", "moving"};
    std::vector<std::string> methods;  // empty: all
    std::vector<std::string> presets;  // beside the methods; "all": all
    std::vector<std::uint32_t> samples{4, 8, 16, 32, 64};
    std::string size = "320x180";
    int frames = 16;  // of a temporal run
    int repeat = 5;   // rounds
    int rays = 256;   // of the truth, for each pixel
    bool temporal_only = false;
    bool single_only = false;
    bool resume = false;
    bool framework = false;
    std::string budget;  // "1ms", "40copies"; empty: not asked
    double error = 0.0;  // 0: not given
    bool fail_if_worse = false;
    std::vector<std::filesystem::path> compare;  // two result files, or none
    std::vector<std::filesystem::path> from;     // result files in place of a run
    std::string device;
    bool validation = false;
    std::filesystem::path json;    // empty: not written
    std::filesystem::path csv;     // likewise
    std::filesystem::path report;  // Markdown
    std::filesystem::path out;     // folder for plots and the journal
};

}  // namespace gloam::cli
