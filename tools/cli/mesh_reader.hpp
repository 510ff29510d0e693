// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The command line of this program that reads a mesh for another run of it; the file comes behind it.
[[nodiscard]] std::vector<std::string> mesh_reader_command();

// Adds the subcommand behind it, which no help shows.
void add_mesh_reader(CLI::App& app, int& status);

}  // namespace gloam::cli
