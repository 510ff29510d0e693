// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/framework/check.hpp"
#include "record/answer_json.hpp"
#include "record/check_report.hpp"
#include "record/failures.hpp"
#include "record/output.hpp"

namespace gloam::cli {

// The messages between workers and their parent are one line of JSON each: record::line_of(), and
// record::from_line(), which throws std::runtime_error with the missing or invalid part.
template <class Io>
void members(Io& io, OwnFileOptions& own) {
    record::each(io, "ranges", own.ranges, "includes", own.includes, "defines", own.defines);
}

template <class Io>
void members(Io& io, CheckTask& task) {
    record::each(io, "equation", task.equation, "variant", task.variant, "inputs", task.run.inputs, "seed",
                 task.run.seed, "coverage", task.coverage, "file", task.file, "own", task.own);
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

// A failure, prepared for a report.
struct FailureBundle {
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

template <class Io>
void members(Io& io, FailureBundle& all) {
    record::each(io, "glsl", all.glsl, "assembly", all.assembly, "spirv", all.spirv, "amber", all.amber,
                 "c_program", all.c_program, "steps", all.steps, "rules", all.rules, "before", all.before,
                 "smallest", all.smallest, "error", all.error);
}

// A message to a worker: a check to run, or one that failed, to be prepared for a report. A check that did
// not run is not tried again, because that has already cost a worker.
struct WorkerRequest {
    CheckTask task;
    std::optional<check::Answer> failed;
};

template <class Io>
void members(Io& io, WorkerRequest& request) {
    record::each(io, "task", request.task, "failed", request.failed);
}

// Prepares a failed check, with the lab's variant. Throws what compiling and running throw.
[[nodiscard]] FailureBundle bundle_of(const check::Lab& lab, const check::Question& question,
                                      const CheckTask& task, const check::Answer& failed);

// A line of the journal, from which --resume continues a check.
struct JournalRow {
    std::string device;
    check::Answer row;
};

template <class Io>
void members(Io& io, JournalRow& kept) {
    record::each(io, "device", kept.device, "row", kept.row);
}

// Writes a failure to DEVICE/EQUATION-VARIANT/{report.txt, shader.comp, shader.spvasm, shader.spv,
// repro.amber} in the folder. report.txt states which parts are missing and why (see FailureBundle::error).
void write_failure(record::OutputFolder& folder, const record::DeviceSummary& device,
                   const check::Answer& row, const FailureBundle& bundle, record::RunAgain again);

}  // namespace gloam::cli
