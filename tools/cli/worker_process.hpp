// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"

namespace gloam::cli {

// A program that answers lines with lines. Its standard input and output are connected to this process; its
// standard error goes to an unnamed file. It is killed with the object, and when the thread that started it
// ends (and so when this process ends for any reason).
class WorkerProcess {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Heard { line, end, silence };

    // command[0] is the path of the program. Throws std::system_error when it cannot be started.
    explicit WorkerProcess(const std::vector<std::string>& command);
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    // Sends a line. Returns false if the program cannot receive it.
    bool send(std::string_view line);

    // Waits for a complete line (returned without its end), for the end of the output, or until the deadline.
    [[nodiscard]] Heard receive(std::string& line, Clock::time_point deadline);

    // Ends the program if it still runs. Returns how it ended: "ended by signal 11 (SEGV: Segmentation
    // fault)", "ended with status 3", with the last text of its standard error.
    [[nodiscard]] std::string end();

    [[nodiscard]] pid_t id() const { return child_; }

  private:
    void start(const std::vector<std::string>& command, int theirs);
    bool wait(Clock::duration patience);
    [[nodiscard]] std::string last_words() const;

    pid_t child_ = -1;
    bool running_ = false;
    int status_ = 0;  // status from waitpid(), after it has ended
    base::FileDescriptor connection_;
    base::FileDescriptor errors_;
    std::string heard_;  // received but not yet returned
};

}  // namespace gloam::cli
