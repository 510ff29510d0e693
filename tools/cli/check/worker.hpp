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

// The command line of a worker: this program, which runs the checks that it reads, one a line, from standard
// input.
[[nodiscard]] std::vector<std::string> worker_command(const CheckerOptions& options);

// The command line that greets with the number of devices: of this driver alone (the path of its manifest),
// or of all.
[[nodiscard]] std::vector<std::string> counting_command(const std::filesystem::path& driver);

// How many devices there are, counted by a process of its own: drivers crash there too. Throws
// std::runtime_error.
[[nodiscard]] std::size_t count_devices();

// Adds the subcommand behind it, which no help shows.
void add_check_worker(CLI::App& app);

}  // namespace gloam::cli
