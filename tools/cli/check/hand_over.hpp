// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/run.hpp"
#include "cli/check/task.hpp"

namespace gloam::cli {

// A request to a worker about a failed check.
struct HandOverRequest {
    CheckTask task;
    bool ran = false;  // false: nothing is run, because running it has already cost a worker
    std::optional<check::Sample> worst;  // a failing input; none: an input accessed a pixel outside an image
};

// A failure, prepared for a report.
struct HandOver {
    std::string glsl;  // self-contained compute shader
    std::string assembly;
    std::vector<std::uint32_t> spirv;
    std::string amber;
    std::string
        shader_test;  // of an OpenGL device, instead of `amber`: `glsl` is then the text that it was given
    std::optional<check::Sample> smallest;  // the simplest input found to fail
    std::string error;                      // why the other members are empty; empty: no error
};

// Each in one line of JSON. Reading throws std::runtime_error.
[[nodiscard]] std::string to_line(const HandOverRequest& request);
[[nodiscard]] bool is_hand_over_request(std::string_view line);
[[nodiscard]] HandOverRequest hand_over_request_from(std::string_view line);
[[nodiscard]] std::string to_line(const HandOver& hand_over);
[[nodiscard]] HandOver hand_over_from(std::string_view line);

// The request for a failing row.
[[nodiscard]] HandOverRequest request_for(const CheckTask& task, const check::Answer& row);

// Prepares it, with the lab's variant. Throws what compiling and running throw.
[[nodiscard]] HandOver make_hand_over(const check::Lab& lab, const check::Question& question,
                                      const HandOverRequest& request, const check::RunOptions& options);

}  // namespace gloam::cli
