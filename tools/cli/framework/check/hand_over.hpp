// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/run.hpp"
#include "record/answer_json.hpp"
#include "record/check_report.hpp"
#include "record/failures.hpp"
#include "record/output.hpp"

namespace gloam::cli {

// One check for a worker. The messages between workers and their parent are one line of JSON each:
// record::line_of(), and record::from_line(), which throws std::runtime_error with the missing or invalid
// part.
struct CheckTask {
    std::string equation;  // its ID; or a function of `file`
    std::string variant;
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool coverage = false;
    std::string file;                   // a user's file, with its folder; empty: an equation of the catalogue
    std::vector<std::string> ranges;    // of its parameters: see check::range_from()
    std::vector<std::string> includes;  // its further include roots
    std::vector<std::string> defines = {};  // macros that hold before it begins
};

template <class Io>
void members(Io& io, CheckTask& task) {
    record::each(io, "equation", task.equation, "variant", task.variant, "inputs", task.inputs, "seed",
                 task.seed, "coverage", task.coverage, "file", task.file, "ranges", task.ranges, "includes",
                 task.includes, "defines", task.defines);
}

// A worker's greeting: its device, or why there is none.
struct Greeting {
    record::DeviceSummary device;
    std::string error;  // empty: there is a device
};

template <class Io>
void members(Io& io, Greeting& greeting) {
    record::each(io, "device", greeting.device, "error", greeting.error);
}

// A request to a worker about a failed check.
struct HandOverRequest {
    CheckTask task;
    bool ran = false;  // false: nothing is run, because running it has already cost a worker
    std::optional<check::Sample> worst;  // a failing input; none: an input accessed a pixel outside an image
};

// A failure, prepared for a report.
struct HandOver {
    std::string glsl;      // self-contained compute shader; of an OpenGL device, the text that it was given
    std::string assembly;  // empty, as all to `before`, of an OpenGL device
    std::vector<std::uint32_t> spirv;
    std::string amber;
    std::string c_program = {};           // record::to_c_program()
    std::vector<std::string> steps = {};  // check::Reproduction
    std::vector<std::string> rules = {};
    std::vector<std::uint32_t> before = {};
    std::optional<check::Sample> smallest;  // the simplest input found to fail
    std::string error;                      // why the other members are empty; empty: no error
};

// Their one line of JSON: record::line_of(), record::from_line().
template <class Io>
void members(Io& io, HandOverRequest& request) {
    record::each(io, "task", request.task, "ran", request.ran, "worst", request.worst);
}

template <class Io>
void members(Io& io, HandOver& all) {
    record::each(io, "glsl", all.glsl, "assembly", all.assembly, "spirv", all.spirv, "amber", all.amber,
                 "c_program", all.c_program, "steps", all.steps, "rules", all.rules, "before", all.before,
                 "smallest", all.smallest, "error", all.error);
}

// A message to a worker: one of the two.
struct WorkerRequest {
    std::optional<CheckTask> check;
    std::optional<HandOverRequest> hand_over;
};

template <class Io>
void members(Io& io, WorkerRequest& request) {
    record::each(io, "check", request.check, "hand_over", request.hand_over);
}

// The request for a failing row.
[[nodiscard]] HandOverRequest request_for(const CheckTask& task, const check::Answer& row);

// Prepares it, with the lab's variant. Throws what compiling and running throw.
[[nodiscard]] HandOver make_hand_over(const check::Lab& lab, const check::Question& question,
                                      const HandOverRequest& request, const check::RunOptions& options);

// A line of the journal, from which --resume continues a check.
struct JournalRow {
    std::string device;
    check::Answer row;
};

template <class Io>
void members(Io& io, JournalRow& kept) {
    record::each(io, "device", kept.device, "row", kept.row);
}

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
    std::filesystem::path write(const record::DeviceSummary& device, const check::Answer& row,
                                const HandOver& hand_over, const record::RunAgain& again);

  private:
    std::optional<record::OutputFolder> folder_;
};

}  // namespace gloam::cli
