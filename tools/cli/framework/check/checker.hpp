// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/framework/check/failure_bundle.hpp"
#include "judge/question.hpp"
#include "record/check_report.hpp"
#include "subject/lab.hpp"
#include "subject/own_function.hpp"

// The check of a user's shader file: no reference, no C++.
namespace gloam::cli {

// Whether a name ends like that of a shader file: .glsl, .frag, .FRAG, .fs ...
[[nodiscard]] bool has_shader_ending(const std::string& word);
// Whether a word of the command line is a shader file, not an equation: it ends like one, or there is a file
// of this name.
[[nodiscard]] bool is_shader_file(const std::string& word);

// A file and functions, of words that name these, or equations of one file instead. Throws
// std::invalid_argument for other words.
[[nodiscard]] std::pair<std::string, std::vector<std::string>> file_and_functions(
    const std::vector<std::string>& words, EquationsNamed* equations);

// The ranges that --range names. Throws std::invalid_argument for an invalid one.
[[nodiscard]] check::Ranges ranges_from(const std::vector<std::string>& texts);

// A user's file with the include roots that the command line adds, read once for all labs, and its functions
// with these names (check::own_functions()); without names all.
struct FileFunctions {
    std::shared_ptr<const check::OwnFile> file;
    check::OwnFunctions functions;
};

// Throws std::runtime_error for a missing file; shader::CompileError for what the preprocessor rejects;
// std::invalid_argument for a function that it does not define, and for a range without a parameter of its
// name.
[[nodiscard]] FileFunctions functions_of(const std::filesystem::path& file,
                                         const std::vector<std::string>& names,
                                         const OwnFileOptions& options);

// A lab for the functions of a file.
[[nodiscard]] check::Lab lab_of(std::shared_ptr<const check::OwnFile> file,
                                const std::string& device = std::string(check::interpreter_name));

// Why nothing is left of a file of which these functions were left out.
[[nodiscard]] std::string why_nothing(const std::vector<check::LeftOut>& left_out);

// The device for checks, and its options.
struct CheckerOptions {
    EquationsNamed* equations = nullptr;
    std::string device;  // name or index; empty: the default
    bool validation = false;
    std::chrono::milliseconds timeout{60'000};  // longest wait for one submission
};

// Runs checks in this process.
class Checker {
  public:
    // Opens the device. Throws like gpu::Device.
    explicit Checker(CheckerOptions options);

    [[nodiscard]] record::DeviceSummary device() const;  // in the form of reports

    // Runs a check. It does not throw for errors of the check; the row reports them. After
    // Reason::device_lost and Reason::hang the device cannot be used any more.
    [[nodiscard]] check::Answer run(const CheckTask& task);

    // Prepares a failure for a report. It does not throw for errors; FailureBundle::error reports them.
    [[nodiscard]] FailureBundle bundle(const CheckTask& task, const check::Answer& failed);

  private:
    const check::Lab& lab(const CheckTask& task);
    [[nodiscard]] check::Question question_of(const CheckTask& task);

    CheckerOptions options_;
    std::vector<check::Question> equations_;
    std::shared_ptr<const check::OwnFile> file_;  // of a user: the tasks of a run are about one
    std::unique_ptr<check::Lab> lab_;
};

// The answer of a check that did not run.
[[nodiscard]] check::Answer answer_without_result(const CheckTask& task,
                                                  const std::vector<check::Question>& equations,
                                                  check::Reason reason, const std::string& error);

// The command line of a worker: this program, which reads checks from standard input, one a line, and runs
// them.
[[nodiscard]] std::vector<std::string> worker_command(const CheckerOptions& options);

// The command line of a process that lists devices (open_device.hpp), with one of the options --list,
// --opengl=EXECUTOR and --manifests.
[[nodiscard]] std::vector<std::string> listing_command(const std::string& option);

}  // namespace gloam::cli
