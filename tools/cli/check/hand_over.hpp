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

// What a worker is asked of a check that failed.
struct HandOverRequest {
    CheckTask task;
    bool ran = false;                    // else nothing is run: that cost a worker already
    std::optional<check::Sample> worst;  // an input that fails; none: an access outside an image did
};

// A failure, ready to report.
struct HandOver {
    std::string glsl;  // self-contained compute shader
    std::string assembly;
    std::vector<std::uint32_t> spirv;
    std::string amber;
    std::optional<check::Sample> smallest;  // the simplest input found to fail
    std::string error;                      // why there is nothing of this; empty: there is
};

// Each in one line of JSON. Reading throws std::runtime_error.
[[nodiscard]] std::string to_line(const HandOverRequest& request);
[[nodiscard]] bool is_hand_over_request(std::string_view line);
[[nodiscard]] HandOverRequest hand_over_request_from(std::string_view line);
[[nodiscard]] std::string to_line(const HandOver& hand_over);
[[nodiscard]] HandOver hand_over_from(std::string_view line);

// What to ask about a failing row.
[[nodiscard]] HandOverRequest request_for(const CheckTask& task, const check::Answer& row);

// Makes one, with the lab's variant. Throws what compiling and running throw.
[[nodiscard]] HandOver make_hand_over(const check::Lab& lab, const check::Question& question,
                                      const HandOverRequest& request, const check::RunOptions& options);

}  // namespace gloam::cli
