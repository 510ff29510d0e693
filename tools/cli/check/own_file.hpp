// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "check/own_function.hpp"
#include "report/check_report.hpp"

namespace gloam::cli {

// The check of somebody's shader file: no reference, no C++.
struct OwnFileRun {
    std::filesystem::path file;
    std::vector<std::string> functions;  // empty: all that the file defines
    std::vector<std::string> ranges;     // see check::range_from()
    std::string device;
    std::vector<shader::Variant> variants;
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool validation = false;
    std::chrono::milliseconds timeout{0};
    std::function<void(const report::DeviceSummary&)> on_device{};  // before the first row
    std::function<void(const check::Answer&)> on_row{};
};

// Whether a word of the command line means a shader file, not an equation.
[[nodiscard]] bool is_shader_file(const std::string& word);

// Judges each function by Vulkan's rules, in this process. Throws std::invalid_argument for a function that
// the file does not define, or a range that no parameter has.
[[nodiscard]] report::CheckReport check_own_file(const OwnFileRun& run);

}  // namespace gloam::cli
