// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/check/checker.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// The command line of a worker: this program, which reads checks from standard input, one a line, and runs
// them.
[[nodiscard]] std::vector<std::string> worker_command(const CheckerOptions& options);

// The command line of a process that greets with the number of devices: of one driver (the path of its
// manifest), or of all.
[[nodiscard]] std::vector<std::string> counting_command(const std::filesystem::path& driver);

// The command line that prints the OpenGL devices of an executor: see gl_devices_line().
[[nodiscard]] std::vector<std::string> gl_listing_command(const std::string& executor);

// The number of devices, counted by another process, because drivers can crash in doing so. Throws
// std::runtime_error.
[[nodiscard]] std::size_t count_devices();

// Adds the hidden subcommand that runs a worker.
void add_check_worker(CLI::App& app);

}  // namespace gloam::cli
