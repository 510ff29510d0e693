// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The command line of this program as a mesh reader for another process; the file's path is appended.
[[nodiscard]] std::vector<std::string> mesh_reader_command();

// Adds the hidden subcommand that reads a mesh.
void add_mesh_reader(CLI::App& app, int& status);

}  // namespace gloam::cli
