// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "base/failure.hpp"
#include "base/process.hpp"
#include "cli/framework/check.hpp"
#include "record/failures.hpp"
#include "record/output.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {

// Prepares a failed check, with the lab's variant. Throws what compiling and running throw.
[[nodiscard]] record::FailureBundle bundle_of(const subject::Lab& lab, const judge::Question& question,
                                              const CheckTask& task, const judge::Answer& failed);

// Writes a failure to NAME/EQUATION-VARIANT/{report.txt, shader.comp, shader.spvasm, shader.spv,
// repro.amber} in the folder. report.txt states which parts are missing and why. name: of no other device.
// command: that repeats it.
void write_failure(record::OutputFolder& folder, const std::string& name, const record::DeviceSummary& device,
                   const judge::Answer& row, const record::FailureBundle& bundle, const std::string& command);

// Runs checks in this process.
class Checker {
  public:
    // Opens the options' device, which is one. Throws like backend::vulkan::Device.
    explicit Checker(const CheckOptions& options);

    [[nodiscard]] const backend::DeviceInfo& device() const { return lab_->info(); }

    // Runs a check. It does not throw for errors of the check; the row reports them. After
    // Reason::device_lost and Reason::hang the device cannot be used any more.
    [[nodiscard]] judge::Answer run(const CheckTask& task);

    // Prepares a failure for a report. It does not throw for errors; FailureBundle::error reports them.
    [[nodiscard]] record::FailureBundle bundle(const CheckTask& task, const judge::Answer& failed);

  private:
    const subject::Lab& lab(const CheckTask& task);
    [[nodiscard]] judge::Question question_of(const CheckTask& task, std::string* described = nullptr);

    CheckOptions options_;
    std::vector<judge::Question> equations_;
    std::shared_ptr<const subject::OwnFile> file_;  // of a user: the tasks of a run are about one
    std::unique_ptr<subject::Lab> lab_;
};

// No worker is available: twice it failed before its greeting, or it has no device (Reason::error).
class NoWorker : public base::Failure {
    using Failure::Failure;
};

// Runs checks in a process of its own, or in this one if the options say so. If the process crashes or stays
// silent, this check alone has no result, and the next one goes to a new process. For one thread.
class Worker {
  public:
    explicit Worker(const CheckOptions& options) : options_(options) {}

    // Its device. Starts the process if there is none, as all of these do. Throws NoWorker.
    const record::DeviceSummary& device();
    // As Checker has them.
    [[nodiscard]] judge::Answer run(const CheckTask& task);
    [[nodiscard]] record::FailureBundle bundle(const CheckTask& task, const judge::Answer& failed);

  private:
    // The answer to a line, the first of which asks for the greeting. Throws base::Failure where there is
    // none; the process has ended then.
    template <class T>
    [[nodiscard]] T asked(const std::string& line);

    CheckOptions options_;
    std::optional<Checker> here_;
    std::optional<base::WorkerProcess> process_;
    record::DeviceSummary device_;
};

// The command line of a process that lists devices (open_device.hpp): "vulkan", those of an OpenGL executor,
// or "manifests", where the Vulkan loader says which drivers it finds.
[[nodiscard]] std::vector<std::string> listing_command(const std::string& what);

}  // namespace gloam::cli
