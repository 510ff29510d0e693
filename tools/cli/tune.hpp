// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam tune`.
struct TuneOptions {
    std::string preset = "quality";       // where the search begins: a name or a file
    std::string method;                   // instead of the preset's
    std::vector<std::string> set;         // NAME=VALUE, fixed; lengths for a radius of 1
    std::vector<std::string> parameters;  // NAME=LEAST:MOST[:log]
    std::string objective = "mean";       // or "relative"
    int evaluations = 60;
    std::optional<double> copies;    // largest mean time of a frame
    bool sequence = false;           // frames in sequence, not alone
    std::vector<std::string> views;  // empty: all
    std::string size = "160x90";
    int frames = 16;
    int scored = 2;
    int rays = 128;
    std::filesystem::path meshes;
    std::string device;
    bool validation = false;
    std::filesystem::path out;     // the preset; empty: not written
    std::filesystem::path report;  // in Markdown; empty: not written
};

// Fits settings of a preset on the tuning half of the views and reports the error on both halves. Returns the
// exit status: 0; 1 if the validation layers reported messages.
[[nodiscard]] int run_tune(const TuneOptions& options);

// Adds the command; `status` receives what it returns.
void add_tune(CLI::App& app, int& status);

}  // namespace gloam::cli
